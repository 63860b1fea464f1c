// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainProbe.h"

#include "vtkDataArray.h"
#include "vtkHeightField.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
TerrainProbe::TerrainProbe(vtkPolyData* mesh, vtkHeightField* heights)
  : Mesh(mesh)
  , Heights(heights)
{
  this->Locator->SetDataSet(mesh);
}

//------------------------------------------------------------------------------
TerrainProbe::~TerrainProbe() = default;

//------------------------------------------------------------------------------
bool TerrainProbe::FindTriangle(double x, double y, Corners& corners)
{
  this->Locator->BuildLocator();
  const double above[3] = { x, y, 1.0 };
  const double below[3] = { x, y, -1.0 };
  double t;
  double point[3];
  double place[3];
  int part;
  vtkIdType cell;
  const double onEdges = 1e-9 * this->Mesh->GetLength();
  if (!this->Locator->IntersectWithLine(above, below, onEdges, t, point, place, part, cell))
  {
    return false;
  }
  vtkNew<vtkIdList> ids;
  this->Mesh->GetCellPoints(cell, ids);
  corners.Weights[0] = 1.0 - place[0] - place[1];
  corners.Weights[1] = place[0];
  corners.Weights[2] = place[1];
  vtkDataArray* coordinates = this->Mesh->GetPointData()->GetTCoords();
  double tuple[3];
  for (int i = 0; i < 3; ++i)
  {
    coordinates->GetTuple(ids->GetId(i), tuple);
    std::copy_n(tuple, 2, corners.Points[i].begin());
  }
  return true;
}

//------------------------------------------------------------------------------
bool TerrainProbe::GetHeight(double x, double y, double& height)
{
  Corners corners;
  if (!this->FindTriangle(x, y, corners))
  {
    return false;
  }
  const Coordinates uv = corners.Interpolate(corners.Weights);
  height = this->Heights->GetHeight(uv[0], uv[1]);
  return this->Heights->IsValid(uv[0], uv[1]) || this->GetTexel(uv, height);
}

//------------------------------------------------------------------------------
bool TerrainProbe::GetTexel(const Coordinates& uv, double& height) const
{
  const double reach = 0.1; // texels, for rounded coordinates
  int size[2];
  this->Heights->GetDimensions(size);
  int texel[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double place = uv[axis] * size[axis] - 0.5;
    texel[axis] = std::clamp(static_cast<int>(std::lround(place)), 0, size[axis] - 1);
    if (std::abs(place - texel[axis]) > reach)
    {
      return false;
    }
  }
  const std::size_t sample = static_cast<std::size_t>(texel[1]) * size[0] + texel[0];
  const unsigned char* validity = this->Heights->GetValidity();
  height = this->Heights->GetSamples()[sample];
  return !validity || validity[sample] != 0;
}

//------------------------------------------------------------------------------
std::vector<double> TerrainProbe::GetDrawnHeights(
  double x, double y, int lowestLevel, int highestLevel)
{
  Corners corners;
  if (!this->FindTriangle(x, y, corners))
  {
    return {};
  }
  std::vector<double> heights = { this->GetHeight(corners, corners.Weights) };
  for (int level = lowestLevel; level <= highestLevel; ++level)
  {
    heights.push_back(this->GetDrawnHeight(corners, level));
  }
  return heights;
}

//------------------------------------------------------------------------------
TerrainProbe::Coordinates TerrainProbe::Corners::Interpolate(const double weights[3]) const
{
  Coordinates uv = { { 0.0, 0.0 } };
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      uv[c] += weights[i] * this->Points[i][c];
    }
  }
  return uv;
}

//------------------------------------------------------------------------------
double TerrainProbe::GetHeight(const Corners& corners, const double weights[3]) const
{
  const Coordinates uv = corners.Interpolate(weights);
  return this->Heights->GetHeight(uv[0], uv[1]);
}

//------------------------------------------------------------------------------
double TerrainProbe::GetDrawnHeight(const Corners& corners, int level) const
{
  const double segments = 1 << level;
  double lowest[3];
  double rest[3];
  double missing = segments;
  for (int i = 0; i < 3; ++i)
  {
    lowest[i] = std::floor(segments * corners.Weights[i]);
    rest[i] = segments * corners.Weights[i] - lowest[i];
    missing -= lowest[i];
  }
  // In a triangle similar to the coarse one, corner i has one more of weight i; in an inverted
  // triangle, the two other weights have one more.
  const bool isTurned = missing > 1.5;
  double height = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    double weights[3];
    for (int i = 0; i < 3; ++i)
    {
      weights[i] = (lowest[i] + ((i == corner) != isTurned ? 1.0 : 0.0)) / segments;
    }
    height += (isTurned ? 1.0 - rest[corner] : rest[corner]) * this->GetHeight(corners, weights);
  }
  return missing < 0.5 ? this->GetHeight(corners, corners.Weights) : height;
}

//------------------------------------------------------------------------------
void TerrainProbe::MoveOnto(double place[2])
{
  this->Locator->BuildLocator();
  const double point[3] = { place[0], place[1], 0.0 };
  double nearest[3];
  vtkIdType cell;
  int part;
  double distance2;
  this->Locator->FindClosestPoint(point, nearest, cell, part, distance2);
  std::copy_n(nearest, 2, place);
}
