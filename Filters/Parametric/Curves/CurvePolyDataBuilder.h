// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvePolyDataBuilder
 * @brief   curves cut into segments as lines, ribbons or tubes
 *
 * Private to the module's own sources.
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

/// What ribbons and tubes are made by.
struct CurveStyle
{
  CurveShape Shape = CurveShape::Lines;
  double Radius = 0.0;
  vtkDataArray* RadiusArray = nullptr; // of the input's points, in place of Radius
  int NumberOfSides = 0;               // of tubes
  dvec4 Eye = dvec4(0.0);              // of ribbons, as of GetEye(); w is 0 or 1
};

class CurvePolyDataBuilder
{
public:
  /// All must live as long.
  CurvePolyDataBuilder(vtkPointSet* input, const CurveMesh& mesh, const std::vector<int>& segments,
    const CurveStyle& style);

  void Build(double noDataMagnitude, vtkPolyData* output);

  /// Names of the arrays that have too few tuples.
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
