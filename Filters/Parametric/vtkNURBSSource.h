// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNURBSSource
 * @brief   convert NURBS curves or surfaces to VTK Bézier cells
 *
 * Degrees, knots, control points and weights define a curve or surface as in L. Piegl, W. Tiller,
 * "The NURBS Book", 1997. Knot insertion decomposes it, exact except for rounding, into one Bézier
 * cell per span between distinct knots. Knots may be unclamped: with n control points of degree p,
 * the curve goes from knot p to knot n (counted from 0). Inner knots have a multiplicity of at most
 * p + 1. With p + 1, the curve may be discontinuous there.
 *
 * The output is a vtkUnstructuredGrid of VTK_BEZIER_QUADRILATERAL cells, or of VTK_BEZIER_CURVE
 * cells if the second dimension is 1. Cells are ordered along the first direction. Points are
 * double. The attribute "HigherOrderDegrees" is a cell array (int, 3 components: the degrees, one
 * for a curve, and zeros). If a weight differs from 1, there is the attribute "RationalWeights", a
 * point array (double). Adjacent cells share the points of their common border. If first and last
 * control points of a closed surface or curve with clamped knots coincide, they are merged as well.
 *
 * The source reports an error and produces an empty output if control points or knots are missing;
 * the number of control points does not match the dimensions, or that of the weights the control
 * points; a direction has fewer than degree + 1 control points; the number of knots is not control
 * points + degree + 1; knots decrease, are all equal or have too large a multiplicity; a weight is
 * not positive, or too large or too small for computations; or a number is not finite.
 *
 * @sa vtkBezierPatchReader
 */
#ifndef vtkNURBSSource_h
#define vtkNURBSSource_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkSmartPointer.h"               // for members
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // for return values

class vtkDoubleArray;
class vtkPoints;

class RELEVOFILTERSPARAMETRIC_EXPORT vtkNURBSSource : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkNURBSSource* New();
  vtkTypeMacro(vtkNURBSSource, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the degree in a direction (0 or 1), 1 to 8, default 3.
   */
  void SetDegree(int direction, int degree);
  int GetDegree(int direction);
  //@}

  //@{
  /**
   * Set the knots of a direction (0 or 1), in non-decreasing order. Required; a curve has direction
   * 0 only.
   */
  void SetKnots(int direction, vtkDoubleArray* knots);
  vtkDoubleArray* GetKnots(int direction);
  //@}

  //@{
  /**
   * Set the number of control points in each direction, at least 1, default 1 and 1. With 1 in the
   * second direction, the source generates a curve.
   */
  void SetDimensions(int first, int second);
  vtkGetVector2Macro(Dimensions, int);
  //@}

  //@{
  /**
   * Set the control points, not multiplied by their weights, ordered along the first direction
   * first. Required.
   */
  void SetControlPoints(vtkPoints* points);
  vtkPoints* GetControlPoints();
  //@}

  //@{
  /**
   * Set the weights of the control points, greater than 0; nullptr (default) if all are 1.
   */
  void SetWeights(vtkDoubleArray* weights);
  vtkDoubleArray* GetWeights();
  //@}

  /// Include the modification times of knots, control points and weights.
  vtkMTimeType GetMTime() override;

protected:
  vtkNURBSSource();
  ~vtkNURBSSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkNURBSSource(const vtkNURBSSource&) = delete;
  void operator=(const vtkNURBSSource&) = delete;

  bool IsDirection(int direction);
  bool IsCurve() const { return this->Dimensions[1] == 1; }
  int Decompose(vtkUnstructuredGrid* output);
  bool CheckPoints();
  bool CheckWeights();
  bool CheckDirection(int direction);
  bool IsRational();
  std::vector<double> CopyKnots(int direction);

  int Degrees[2] = { 3, 3 };
  int Dimensions[2] = { 1, 1 };
  vtkSmartPointer<vtkDoubleArray> Knots[2];
  vtkSmartPointer<vtkPoints> ControlPoints;
  vtkSmartPointer<vtkDoubleArray> Weights;
};

#endif
