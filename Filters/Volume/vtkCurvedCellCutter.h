// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCurvedCellCutter
 * @brief   cut 3D cells with a plane or another implicit function, curved cells along their shape
 *
 * vtkCutter divides curved cells into a few linear ones first, so that its sections have straight
 * outlines. This filter uses the cells' own shape functions: each point of the output is on the
 * surface of the function and in the cell, and its data are those of the cell there. Between the
 * points, shape and data are linear; there are enough points for Tolerance and FieldTolerance. It
 * supports all 3D
 * cells of VTK and all data sets: linear cells and polyhedra, quadratic cells, and Lagrange and
 * Bézier cells of degrees 1 to 8 ("HigherOrderDegrees", "RationalWeights").
 *
 * Output port 0 has the polygons of the section, one for a linear cell and several for a curved
 * one. Seen from where the function is negative, their points are counter-clockwise, so that they
 * close the part of the mesh where it is positive. Output port 1 has the lines where the section
 * meets faces of cells. Both have the point arrays, interpolated, the cell arrays of the cells, and
 * "vtkOriginalCellIds" (vtkIdType).
 *
 * Points that are exactly on the surface count as positive. A layer of faces on the surface is thus
 * part of the section if its cells on the negative side exist. Cells that do not share points keep
 * their own values, so that discontinuous fields stay discontinuous.
 *
 * Ghost cells keep vtkGhostType. Hidden cells are ignored. The filter reports the first invalid
 * cell and the number of others, and skips them, as vtkPatchSurfaceFilter does. A missing function
 * is an error.
 *
 * @sa vtkCutter vtkPatchSurfaceFilter
 */
#ifndef vtkCurvedCellCutter_h
#define vtkCurvedCellCutter_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the function

#include <vector> // for cells

class vtkDataSet;
class vtkImplicitFunction;

class RELEVOFILTERSVOLUME_EXPORT vtkCurvedCellCutter : public vtkPolyDataAlgorithm
{
public:
  static vtkCurvedCellCutter* New();
  vtkTypeMacro(vtkCurvedCellCutter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the function, usually a vtkPlane; none by default. The section is where it is 0. Along an
   * edge of a linear cell, it is taken as linear.
   */
  virtual void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  //@}

  //@{
  /**
   * Set the largest distance between the section and the true shape of curved cells, as a share of
   * the diagonal of the input's bounding box, from 1e-7 to 1; 1e-4 by default. Other values are
   * errors. The distance is estimated from second derivatives at a number of points. At most 32
   * pieces divide a cell in each direction (twice as many for tetrahedra and wedges).
   */
  void SetTolerance(double share);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * Set the largest error of point arrays between the points of the section of curved cells, as a
   * share of the array's range, from 1e-4 to 1; 4e-3 by default, about one step of 255 colours. It
   * counts for all arrays of float and double. At most 32 pieces divide a cell for it in each
   * direction. Other values are errors.
   */
  void SetFieldTolerance(double share);
  vtkGetMacro(FieldTolerance, double);
  //@}

  /**
   * Return the lines on the faces of cells. For a composite data set, whose output is one, use
   * GetOutputDataObject(0) and (1).
   */
  vtkPolyData* GetLines() { return this->GetOutput(1); }

  vtkMTimeType GetMTime() override;

protected:
  vtkCurvedCellCutter();
  ~vtkCurvedCellCutter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkCurvedCellCutter(const vtkCurvedCellCutter&) = delete;
  void operator=(const vtkCurvedCellCutter&) = delete;

  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  double Tolerance = 1e-4;
  double FieldTolerance = 4e-3;

  // The solid cells without faults, and the input that they belong to.
  std::vector<vtkIdType> SolidCells;
  vtkDataSet* CheckedInput = nullptr;
  vtkMTimeType CheckTime = 0;

  void CheckCells(vtkDataSet* input);
  int Cut(vtkDataSet* input, vtkPolyData* polygons, vtkPolyData* lines);
};

#endif
