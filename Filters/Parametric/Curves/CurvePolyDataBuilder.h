// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvePolyDataBuilder
 * @brief   tessellation of curves to lines, ribbons or tubes
 *
 * Private to the module.
 */
#ifndef CurvePolyDataBuilder_h
#define CurvePolyDataBuilder_h

#include "Curves/CurveFrames.h"
#include "Curves/CurveRows.h"
#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

#include <string> // for names
#include <vector> // for members

class vtkDataArray;
class vtkPointSet;
class vtkPolyData;

namespace relevo
{
class CurveMesh;

enum class CurveShape
{
  Lines,
  Ribbons,
  Tubes
};

/// The shape of ribbons and tubes.
struct CurveStyle
{
  CurveShape Shape = CurveShape::Lines;
  double Radius = 0.0;
  vtkDataArray* RadiusArray = nullptr; // point array of the input that replaces Radius
  int NumberOfSides = 0;               // for tubes
  dvec4 Eye = dvec4(0.0);              // for ribbons, see GetEye(); w is 0 or 1
};

class CurvePolyDataBuilder
{
public:
  /// All arguments must outlive this object.
  CurvePolyDataBuilder(vtkPointSet* input, const CurveMesh& mesh, const std::vector<int>& segments,
    const CurveStyle& style);

  void Build(double noDataMagnitude, vtkPolyData* output);

  /// Returns the names of arrays with too few tuples.
  const std::vector<std::string>& GetShortArrays() const { return this->ShortArrays; }

private:
  void BuildPoints(vtkPolyData* output);
  std::vector<vtkIdType> BuildLines(vtkPolyData* output) const;
  std::vector<vtkIdType> BuildTriangles(vtkPolyData* output) const;
  std::vector<vtkIdType> CountTriangles() const;
  vtkIdType* AddStrip(vtkIdType curve, int from, int to, vtkIdType* next) const;
  vtkIdType* AddCap(vtkIdType curve, int end, vtkIdType* next) const;

  vtkPointSet* Input;
  const CurveMesh& Mesh;
  const CurveStyle& Style;
  CurveFrames Frames;
  CurveRows Rows;
  std::vector<std::string> ShortArrays;
};
}

#endif
