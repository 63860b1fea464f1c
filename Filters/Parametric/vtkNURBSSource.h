// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNURBSSource
 * @brief   non-uniform rational B-splines, curves or surfaces, as VTK's Bézier cells
 *
 * A curve or surface is given by degrees, knots, control points and weights, as L. Piegl and W.
 * Tiller have them ("The NURBS Book", 1997). Knot insertion takes it apart, exactly but for
 * rounding, into a Bézier cell for each span between knots that differ. Knots need not be clamped:
 * of n control points of degree p the curve goes from knot p to knot n (counted from 0). An inner
 * knot may be there up to p + 1 times; with p + 1 the curve may jump there.
 *
 * Output: a vtkUnstructuredGrid of VTK_BEZIER_QUADRILATERAL cells, or, with a second dimension of
 * 1, of VTK_BEZIER_CURVE cells, those of the first direction's spans following one another. Points
 * in double; the cell array "HigherOrderDegrees" (int, 3 components: both degrees, of a curve one,
 * and 0); if a weight differs from 1, the point array "RationalWeights" (double). Both are VTK's
 * attributes of that name. Cells that have a border in common share its points; where a closed
 * one's first and last control points are the same, with clamped knots, they are one point too.
 *
 * Errors, with an empty output, say which: no control points or knots; another number of control
 * points than the dimensions tell of, or of weights; too few control points for a degree; another
 * number of knots than control points + degree + 1; knots that fall, that are there too often or
 * that are all one; weights of 0 or less, or too large or too small to compute with; anything that
 * is not finite.
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
   * The degree of a direction, 0 or 1: in [1, 8], default 3.
   */
  void SetDegree(int direction, int degree);
  int GetDegree(int direction);
  //@}

  //@{
  /**
   * The knots of a direction, 0 or 1, which never fall; needed, of a curve for direction 0 alone.
   */
  void SetKnots(int direction, vtkDoubleArray* knots);
  vtkDoubleArray* GetKnots(int direction);
  //@}

  //@{
  /**
   * How many control points there are in each direction, at least 1, default 1 and 1. If there is
   * 1 in the second direction, it is a curve.
   */
  void SetDimensions(int first, int second);
  vtkGetVector2Macro(Dimensions, int);
  //@}

  //@{
  /**
   * The control points, not multiplied with their weights, those of the first direction following
   * one another; needed.
   */
  void SetControlPoints(vtkPoints* points);
  vtkPoints* GetControlPoints();
  //@}

  //@{
  /**
   * A weight for each control point, more than 0; default nullptr: all are 1.
   */
  void SetWeights(vtkDoubleArray* weights);
  vtkDoubleArray* GetWeights();
  //@}

  /// Includes the modification times of knots, control points and weights.
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
