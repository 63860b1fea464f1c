// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveMesh
 * @brief   the curves among the cells of a data set, as rational Bézier curves
 *
 * Private to the modules' own sources.
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
    /// Whether point data are given at its nodes, rather than as coefficients.
    bool IsLagrange;
  };

  /**
   * The curves of a vtkUnstructuredGrid or a vtkPolyData: lines, poly-lines (a curve of degree 1
   * for each segment), quadratic edges, cubic lines, Lagrange and Bézier curves. Cells of other
   * dimensions, blanked ones and those that another piece has are none. What is wrong with cells is
   * in GetError(), curves whose control points are all at one place in GetWarning(); both are left
   * out.
   */
  void Build(vtkPointSet* input);

  /// Sentences, the first cell named; empty for nothing.
  const std::string& GetError() const { return this->Error; }
  const std::string& GetWarning() const { return this->Warning; }

  const std::vector<Curve>& GetCurves() const { return this->Curves; }
  vtkIdType GetNumberOfCurves() const { return static_cast<vtkIdType>(this->Curves.size()); }

  /// Control points: x, y, z, not multiplied with the weight, and the weight. Curves that share a
  /// point of the input have the same bits there.
  const std::vector<dvec4>& GetPoints() const { return this->Points; }
  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }

  /// The input's point that each control point is made of, or first of all made of.
  const std::vector<vtkIdType>& GetNodes() const { return this->Nodes; }

  /// Whether a weight differs from 1.
  bool IsRational() const { return this->Rational; }

  /// Coefficients of a point array of the input, in the basis of the control points: a tuple for
  /// each of them.
  std::vector<double> ComputeCoefficients(vtkDataArray* array) const;

  /// The control polygons, as metrics see them: each curve has its own points and is a line cell;
  /// with the attribute RationalWeights where a weight differs from 1.
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
