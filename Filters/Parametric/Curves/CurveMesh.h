// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveMesh
 * @brief   the curves of a data set as rational Bézier curves
 *
 * Private to the modules.
 */
#ifndef CurveMesh_h
#define CurveMesh_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkSmartPointer.h"               // for return values
#include "vtkType.h"

#include <string> // for messages
#include <vector> // for members

class vtkDataArray;
class vtkPointSet;
class vtkPolyData;

namespace relevo
{
class RELEVOFILTERSPARAMETRIC_EXPORT CurveMesh
{
public:
  struct Curve
  {
    vtkIdType FirstPoint; // of its Degree + 1 control points
    vtkIdType Cell;       // of the input
    int Degree;           // 1 to 8
    /// Whether point data are values at the nodes instead of coefficients.
    bool IsLagrange;
  };

  /**
   * Reads the curves of a vtkUnstructuredGrid or a vtkPolyData: lines, poly-lines (a curve of
   * degree 1 for each segment), quadratic edges, cubic lines, Lagrange and Bézier curves. Cells of
   * other dimensions, blanked cells and cells of other pieces are ignored. Invalid cells are
   * skipped and reported by GetError(), curves whose control points all coincide by GetWarning().
   */
  void Build(vtkPointSet* input);

  /// Return sentences that name the first cell, or "".
  const std::string& GetError() const { return this->Error; }
  const std::string& GetWarning() const { return this->Warning; }

  const std::vector<Curve>& GetCurves() const { return this->Curves; }
  vtkIdType GetNumberOfCurves() const { return static_cast<vtkIdType>(this->Curves.size()); }

  /// Returns control points: x, y, z, not multiplied by the weight, and the weight. Curves that
  /// share an input point have bitwise identical control points there.
  const std::vector<dvec4>& GetPoints() const { return this->Points; }
  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }

  /// Returns for each control point the input point that it is, or mainly is, computed from.
  const std::vector<vtkIdType>& GetNodes() const { return this->Nodes; }

  /// Whether a weight differs from 1.
  bool IsRational() const { return this->Rational; }

  /// Computes the coefficients of a point array of the input, a tuple for each control point.
  std::vector<double> ComputeCoefficients(vtkDataArray* array) const;

  /// Creates the control polygons for metrics: a line cell with separate points for each curve, and
  /// the attribute RationalWeights if a weight differs from 1.
  vtkSmartPointer<vtkPolyData> NewControlPolygons() const;

private:
  std::vector<Curve> Curves;
  std::vector<dvec4> Points;
  std::vector<vtkIdType> Nodes;
  bool Rational = false;
  std::string Error;
  std::string Warning;
};
}

#endif
