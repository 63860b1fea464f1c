// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/CurveBuffers.h"

#include "Curves/CurveFrames.h"
#include "Curves/CurveMesh.h"
#include "OpenGL/ContextFacts.h"
#include "Splines/WeightScale.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Return the number of floats per point.
int GetComponents(bool isRational)
{
  return isRational || !HasBuffersOfThreeFloats() ? 4 : 3;
}

int GetLogarithm(int powerOfTwo)
{
  int logarithm = 0;
  for (; powerOfTwo > 1; powerOfTwo /= 2)
  {
    ++logarithm;
  }
  return logarithm;
}
}

bool CurveBuffers::Upload(
  vtkOpenGLRenderWindow* window, const CurveMesh& curves, const dvec3& origin)
{
  this->Rational = curves.IsRational();
  const int components = GetComponents(this->Rational);
  const WeightScale scale(
    0, curves.GetNumberOfPoints(), [&](vtkIdType i) { return curves.GetPoints()[i]; });
  std::vector<float> points;
  points.reserve(components * curves.GetPoints().size());
  for (const dvec4& point : curves.GetPoints())
  {
    const vec3 place(dvec3(point) - origin);
    points.insert(points.end(), { place.x, place.y, place.z });
    if (components == 4)
    {
      points.push_back(scale.GetWeight(point));
    }
  }
  const std::vector<CurveMesh::Curve>& all = curves.GetCurves();
  this->Degree = all.empty() ? 0 : all.front().Degree;
  std::vector<unsigned int> records;
  records.reserve(all.size());
  for (const CurveMesh::Curve& curve : all)
  {
    this->Degree = curve.Degree == this->Degree ? this->Degree : 0;
    records.push_back(static_cast<unsigned int>(curve.FirstPoint) << 3 |
      static_cast<unsigned int>(curve.Degree - 1));
  }
  this->Curves.ReleaseGraphicsResources(window);
  this->Cells.ReleaseGraphicsResources(window);
  return this->Points.Upload(window, points, components) &&
    (this->Degree > 0 || this->Curves.Upload(window, records));
}

bool CurveBuffers::UploadCells(vtkOpenGLRenderWindow* window, const CurveMesh& curves)
{
  if (!this->Cells.IsEmpty())
  {
    return true;
  }
  std::vector<unsigned int> cells;
  cells.reserve(curves.GetCurves().size());
  for (const CurveMesh::Curve& curve : curves.GetCurves())
  {
    cells.push_back(static_cast<unsigned int>(curve.Cell));
  }
  return this->Cells.Upload(window, cells);
}

bool CurveBuffers::UploadRadii(vtkOpenGLRenderWindow* window, const std::vector<double>& radii)
{
  this->Radii.ReleaseGraphicsResources(window);
  return radii.empty() ||
    this->Radii.Upload(window, std::vector<float>(radii.begin(), radii.end()), 1);
}

bool CurveBuffers::UploadFrames(vtkOpenGLRenderWindow* window, const CurveFrames& frames)
{
  const int components = GetComponents(false);
  std::vector<unsigned int> records;
  records.reserve(frames.GetStations().size());
  for (const CurveFrames::Stations& stations : frames.GetStations())
  {
    records.push_back(static_cast<unsigned int>(stations.First) << 5 |
      (stations.IsStartOpen ? 16u : 0u) | (stations.IsEndOpen ? 8u : 0u) |
      static_cast<unsigned int>(GetLogarithm(stations.Intervals)));
  }
  std::vector<float> vectors;
  vectors.reserve(2 * components * frames.GetTangents().size());
  const auto add = [&](const dvec3& v)
  {
    const vec4 values(dvec4(v, 0.0));
    vectors.insert(vectors.end(), &values.x, &values.x + components);
  };
  for (size_t i = 0; i < frames.GetTangents().size(); ++i)
  {
    add(frames.GetTangents()[i]);
    add(frames.GetNormals()[i]);
  }
  return this->Frames.Upload(window, records) && this->Stations.Upload(window, vectors, components);
}

void CurveBuffers::Activate(vtkShaderProgram* program)
{
  this->Points.Activate(program, "relevoControlPoints");
  this->Curves.Activate(program, "relevoCurves");
  this->Cells.Activate(program, "relevoCells");
  this->Radii.Activate(program, "relevoRadii");
  this->Frames.Activate(program, "relevoFrames");
  this->Stations.Activate(program, "relevoStations");
}

void CurveBuffers::Deactivate()
{
  this->Points.Deactivate();
  this->Curves.Deactivate();
  this->Cells.Deactivate();
  this->Radii.Deactivate();
  this->Frames.Deactivate();
  this->Stations.Deactivate();
}

vtkTypeInt64 CurveBuffers::GetMemorySize() const
{
  return this->Points.GetMemorySize() + this->Curves.GetMemorySize() + this->Cells.GetMemorySize() +
    this->Radii.GetMemorySize() + this->Frames.GetMemorySize() + this->Stations.GetMemorySize();
}

void CurveBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Points.ReleaseGraphicsResources(window);
  this->Curves.ReleaseGraphicsResources(window);
  this->Cells.ReleaseGraphicsResources(window);
  this->Radii.ReleaseGraphicsResources(window);
  this->Frames.ReleaseGraphicsResources(window);
  this->Stations.ReleaseGraphicsResources(window);
}
}
