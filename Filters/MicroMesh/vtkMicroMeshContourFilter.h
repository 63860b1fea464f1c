// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMicroMeshContourFilter
 * @brief   encode isosurfaces of a volume as a micro-mesh, block by block
 *
 * The input is an image or an unstructured grid with point scalars. The filter divides it into
 * blocks. It contours each block, with vtkFlyingEdges3D or vtkContourGrid, and encodes the surface
 * with vtkMicroMeshFilter. Then it releases the triangles. The whole isosurface is therefore never
 * in memory. The output is one micro-mesh, see vtkMicroMeshFilter.
 *
 * If the source of an image can produce parts of its extent, the filter requests only the points of
 * one block at a time, and the whole image is never in memory either. Unstructured grids are read
 * as a whole.
 *
 * The isosurface has the same triangles as with vtkFlyingEdges3D or vtkContourGrid. All of its
 * points are within the tolerance of the result, and all points of the result within the tolerance
 * of the isosurface; see GetError(). Points on the common borders of blocks are points of the
 * output, and edges between them are edges of the output. Neighbouring blocks therefore match to
 * the bit, and the result has no cracks. Normals at borders are those of the faces of all blocks.
 * The result does not depend on the number of threads, but it depends on BlockSize.
 *
 * Point arrays of the volume are interpolated on the isosurface and sampled on the grids
 * (AttributesOn()). Cell arrays are not part of the output. Convert them with
 * vtkCellDataToPointData.
 *
 * Isosurfaces have no sharp edges: at steps between voxels, normals are interpolated. If you need
 * sharp edges, contour the whole volume and use vtkMicroMeshFilter.
 *
 * The scalars are the active point scalars. SetInputArrayToProcess(0, 0, 0,
 * vtkDataObject::FIELD_ASSOCIATION_POINTS, name) selects another array. Triangles at points with
 * NaN are left out. In a pipeline with pieces, piece 0 is the whole result.
 *
 * A tolerance or a contour value that is not set, missing scalars, and scalars with several
 * components are errors, and the output is empty.
 *
 * @sa vtkMicroMeshFilter vtkMicroMeshSurface vtkFlyingEdges3D vtkContourGrid
 */
#ifndef vtkMicroMeshContourFilter_h
#define vtkMicroMeshContourFilter_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for members
#include <string> // for errors

class vtkContourValues;
class vtkImageData;
class vtkUnstructuredGrid;

class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshContourFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkMicroMeshContourFilter* New();
  vtkTypeMacro(vtkMicroMeshContourFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the isovalues, as in vtkFlyingEdges3D, at most 1000. There is none by default. Other
   * numbers are an error and change nothing.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  void SetNumberOfContours(int number);
  int GetNumberOfContours();
  void GenerateValues(int number, double rangeStart, double rangeEnd);
  //@}

  //@{
  /**
   * Set the largest distance between isosurface and result, a length above 0. It must be set.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * Set the part of the triangles to remove for the coarse mesh, from 0 to 1. The default is 0.99.
   * The tolerance and the borders of blocks have priority.
   */
  void SetTargetReduction(double reduction);
  vtkGetMacro(TargetReduction, double);
  //@}

  //@{
  /**
   * Set the highest level of grids, from 0 to 7. The default is 5.
   */
  void SetMaximumLevel(int level);
  vtkGetMacro(MaximumLevel, int);
  //@}

  //@{
  /**
   * Set the size of blocks of an image, in cells per side, at least 8. The default is 256. Larger
   * blocks take more memory and result in fewer coarse faces, because there are fewer borders. A
   * block of an unstructured grid has at most 4 times the square of this number of those cells that
   * contain an isovalue, which is about as many triangles.
   */
  void SetBlockSize(int cells);
  vtkGetMacro(BlockSize, int);
  //@}

  //@{
  /**
   * Set whether the numeric point arrays of the volume, except the scalars, normals and ids, are
   * part of the output. On by default.
   */
  vtkSetMacro(Attributes, bool);
  vtkGetMacro(Attributes, bool);
  vtkBooleanMacro(Attributes, bool);
  //@}

  //@{
  /**
   * Set whether the isovalue of each point is part of the output, as a point array with the name of
   * the scalars. Off by default.
   */
  vtkSetMacro(ComputeScalars, bool);
  vtkGetMacro(ComputeScalars, bool);
  vtkBooleanMacro(ComputeScalars, bool);
  //@}

  //@{
  /**
   * Set whether the gradients of an image are part of the output, as the point array "Gradients"
   * (float, 3 components), in units of the scalars per length. Off by default. For unstructured
   * grids, use vtkGradientFilter, whose result is a point array of the volume.
   */
  vtkSetMacro(ComputeGradients, bool);
  vtkGetMacro(ComputeGradients, bool);
  vtkBooleanMacro(ComputeGradients, bool);
  //@}

  /**
   * Return the larger bound of the distances from the isosurface to the result and back, of the
   * last update, as a length.
   */
  vtkGetMacro(Error, double);

  /**
   * Return the number of triangles of the isosurface, of the last update.
   */
  vtkGetMacro(NumberOfTriangles, vtkIdType);

  /**
   * Return the number of blocks, of the last update.
   */
  vtkGetMacro(NumberOfBlocks, int);

  vtkMTimeType GetMTime() override;

protected:
  vtkMicroMeshContourFilter();
  ~vtkMicroMeshContourFilter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkContourValues> ContourValues;
  double Tolerance = 0.0;
  double TargetReduction = 0.99;
  int MaximumLevel = 5;
  int BlockSize = 256;
  bool Attributes = true;
  bool ComputeScalars = false;
  bool ComputeGradients = false;
  double Error = 0.0;
  vtkIdType NumberOfTriangles = 0;
  int NumberOfBlocks = 0;

private:
  vtkMicroMeshContourFilter(const vtkMicroMeshContourFilter&) = delete;
  void operator=(const vtkMicroMeshContourFilter&) = delete;

  struct Work;

  bool CheckSettings();
  bool FindScalarsName(vtkInformationVector** inputVector);
  int RunStep(vtkInformation* request, vtkInformationVector** inputVector);
  int ContourImage(vtkImageData* image, bool isWhole);
  int ContourGrid(vtkUnstructuredGrid* grid);
  int EncodeBlock(vtkPolyData* surface);
  bool EncodeSurface(vtkPolyData* surface, vtkSmartPointer<vtkPolyData>& result, double& error);
  void Report(double share);
  bool Finish(vtkPolyData* output);
  void Fail(const std::string& error);

  std::unique_ptr<Work> Current; // of the update in progress
};

#endif
