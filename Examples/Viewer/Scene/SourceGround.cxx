// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SourceGround.h"

#include "vtkDisplacement.h"
#include "vtkHeightMap.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <limits>
#include <vector>

//------------------------------------------------------------------------------
SourceGround::SourceGround(vtkTerrainSource* source, vtkPolyData* mesh)
  : Source(source)
  , Mesh(mesh)
  , Probe(mesh, source->GetHeightMap())
{
}

//------------------------------------------------------------------------------
SourceGround::~SourceGround() = default;

//------------------------------------------------------------------------------
void SourceGround::SetLevels(int lowest, int highest)
{
  this->LowestLevel = lowest;
  this->HighestLevel = highest;
}

//------------------------------------------------------------------------------
bool SourceGround::GetHeight(double x, double y, double& height)
{
  return this->Probe.GetHeight(x, y, height);
}

//------------------------------------------------------------------------------
double SourceGround::GetZ(double height)
{
  vtkDisplacement* displacement = this->Source->GetDisplacement();
  return displacement->GetOffset() + displacement->GetScale() * height;
}

//------------------------------------------------------------------------------
bool SourceGround::GetHighestGround(double x, double y, double, double& z)
{
  const std::vector<double> heights =
    this->Probe.GetDrawnHeights(x, y, this->LowestLevel, this->HighestLevel);
  z = -std::numeric_limits<double>::infinity();
  for (double height : heights)
  {
    z = std::max(z, this->GetZ(height));
  }
  return !heights.empty();
}

//------------------------------------------------------------------------------
void SourceGround::MoveOnto(double place[2])
{
  this->Probe.MoveOnto(place);
}

//------------------------------------------------------------------------------
std::array<double, 4> SourceGround::GetExtent()
{
  double bounds[6];
  this->Mesh->GetBounds(bounds);
  return { { bounds[0], bounds[1], bounds[2], bounds[3] } };
}

//------------------------------------------------------------------------------
bool SourceGround::HasCoordinateSystem()
{
  return *this->Source->GetCoordinateSystem() != '\0';
}

//------------------------------------------------------------------------------
bool SourceGround::IsGeographic()
{
  return this->Source->IsGeographic();
}

//------------------------------------------------------------------------------
double SourceGround::GetVerticalUnit()
{
  const double exaggeration = this->Source->GetExaggeration();
  return exaggeration == 0.0 ? 0.0 : this->Source->GetDisplacement()->GetScale() / exaggeration;
}

//------------------------------------------------------------------------------
bool SourceGround::ToRaster(const double place[2], double coordinates[2])
{
  const double terrain[3] = { place[0], place[1], 0.0 };
  double map[3];
  const bool isConverted = this->Source->TerrainToMap(terrain, map);
  std::copy_n(map, isConverted ? 2 : 0, coordinates);
  return isConverted;
}

//------------------------------------------------------------------------------
bool SourceGround::FromRaster(const double coordinates[2], double place[2])
{
  const double map[3] = { coordinates[0], coordinates[1], 0.0 };
  double terrain[3];
  const bool isConverted = this->Source->MapToTerrain(map, terrain);
  std::copy_n(terrain, isConverted ? 2 : 0, place);
  return isConverted;
}

//------------------------------------------------------------------------------
bool SourceGround::FromDegrees(const double degrees[2], double place[2])
{
  const double geographic[3] = { degrees[0], degrees[1], 0.0 };
  double terrain[3];
  const bool isConverted = this->Source->GeographicToTerrain(geographic, terrain);
  std::copy_n(terrain, isConverted ? 2 : 0, place);
  return isConverted;
}

//------------------------------------------------------------------------------
bool SourceGround::ToDegrees(const double[2], double[2])
{
  return false;
}
