// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainClamp.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Compatibility/VTKCompatibility.h"
#include "Draping/DrawnSurface.h"
#include "Draping/RasterSurface.h"
#include "Draping/TerrainDraping.h"
#include "Lattice/HeightLattice.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

// The surface for the input, and where it is.
struct vtkTerrainClamp::vtkTerrain
{
  const relevo::AdaptiveTerrain& Frame;
  relevo::DrapedSurface& Surface;
  vtkTerrainPyramid* Pyramid;
};

namespace
{
using relevo::MapPosition;

// The column and row of coordinates in the raster's own system.
MapPosition GetSample(const relevo::RasterDescription& contents, const MapPosition& coordinates)
{
  const relevo::Georeference& location = contents.Location;
  const std::array<double, 2> uv = location.Parameters(coordinates);
  return { { (location.FlipColumns ? 1.0 - uv[0] : uv[0]) * contents.Width - 0.5,
    (location.FlipRows ? 1.0 - uv[1] : uv[1]) * contents.Height - 0.5 } };
}

// Whether the coordinates are those of the map frame.
bool IsOnMap(const relevo::AdaptiveTerrain& terrain, int coordinateType)
{
  return coordinateType == vtkTerrainClamp::WORLD && !terrain.GetGlobe();
}

MapPosition GetPeriod(const relevo::RasterDescription& contents)
{
  const relevo::Georeference& location = contents.Location;
  if (location.System != relevo::Georeference::Kind::Geographic)
  {
    return { { 0.0, 0.0 } };
  }
  const MapPosition origin = GetSample(contents, { { 0.0, 0.0 } });
  const MapPosition shifted = GetSample(contents, { { 360.0 / location.Unit, 0.0 } });
  return { { shifted[0] - origin[0], shifted[1] - origin[1] } };
}
}

vtkStandardNewMacro(vtkTerrainClamp);

//------------------------------------------------------------------------------
vtkTerrainClamp::vtkTerrainClamp() = default;

//------------------------------------------------------------------------------
vtkTerrainClamp::~vtkTerrainClamp() = default;

vtkCxxSetSmartPointerMacro(vtkTerrainClamp, Mapper, vtkTerrainMapper);
vtkCxxSetSmartPointerMacro(vtkTerrainClamp, Pyramid, vtkTerrainPyramid);

//------------------------------------------------------------------------------
vtkTerrainMapper* vtkTerrainClamp::GetMapper()
{
  return this->Mapper;
}

//------------------------------------------------------------------------------
vtkTerrainPyramid* vtkTerrainClamp::GetPyramid()
{
  return this->Pyramid;
}

//------------------------------------------------------------------------------
void vtkTerrainClamp::SetOffset(double distance)
{
  relevo::SetInRange(
    this, "Offset", this->Offset, distance, -relevo::LargestDouble, relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainClamp::SetCoordinateType(int type)
{
  relevo::SetChoice(
    this, "CoordinateType", this->CoordinateType, type, { "WORLD", "RASTER", "GEOGRAPHIC" });
}

//------------------------------------------------------------------------------
void vtkTerrainClamp::SetExaggeration(double factor)
{
  relevo::SetInRange(this, "Exaggeration", this->Exaggeration, factor, -relevo::LargestDouble,
    relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainClamp::SetMaximumError(double meters)
{
  relevo::SetInRange(this, "MaximumError", this->MaximumError, meters,
    std::numeric_limits<double>::min(), relevo::LargestDouble);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTerrainClamp::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Mapper)
  {
    return std::max({ time, this->Mapper->GetMTime(), this->Mapper->GetDrawnMTime() });
  }
  return this->Pyramid ? std::max(time, this->Pyramid->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkTerrainClamp::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  std::string error;
  if (!relevo::FitsMemory([&] { error = this->Clamp(input, output); }))
  {
    error = "Not enough memory for the parts of the input.";
  }
  if (!error.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  if (relevo::IsAborted(this))
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkTerrainClamp::Clamp(vtkPolyData* input, vtkPolyData* output)
{
  if (!this->Mapper && !this->Pyramid)
  {
    return "There is no terrain: call SetMapper() or SetPyramid().";
  }
  return this->Mapper ? this->ClampToMapper(input, output) : this->ClampToPyramid(input, output);
}

//------------------------------------------------------------------------------
std::string vtkTerrainClamp::ClampToMapper(vtkPolyData* input, vtkPolyData* output)
{
  this->Mapper->GetBounds(); // opens the raster
  const relevo::AdaptiveTerrain* terrain = this->Mapper->GetDrawnTerrain();
  if (!terrain)
  {
    return ""; // the mapper has reported the error
  }
  relevo::DrawnSurface surface(*terrain, this->Mapper->GetExaggeration());
  return this->ClampTo({ *terrain, surface, this->Mapper->GetPyramid() }, input, output);
}

//------------------------------------------------------------------------------
std::string vtkTerrainClamp::ClampToPyramid(vtkPolyData* input, vtkPolyData* output)
{
  if (!this->Pyramid->Update())
  {
    return std::string("The pyramid has an error: ") + this->Pyramid->GetErrorMessage();
  }
  const std::shared_ptr<const relevo::HeightLattice> lattice = this->Pyramid->GetLattice();
  const relevo::AdaptiveTerrain frame(lattice);
  const std::string location = frame.FindLocationError();
  if (!location.empty())
  {
    return this->Pyramid->GetFileName() + location;
  }
  relevo::RasterSurface surface(*lattice, frame.GetPlacement(this->Exaggeration),
    this->MaximumError / lattice->Describe().VerticalUnit);
  const std::string error = this->ClampTo({ frame, surface, this->Pyramid }, input, output);
  if (!surface.GetError().empty())
  {
    vtkErrorMacro(<< "Cannot read " << this->Pyramid->GetFileName() << ": " << surface.GetError()
                  << ".");
  }
  return error;
}

//------------------------------------------------------------------------------
bool vtkTerrainClamp::FindPositions(
  const vtkTerrain& terrain, vtkPolyData* input, std::vector<MapPosition>& positions) const
{
  const relevo::GlobeShape* globe = terrain.Frame.GetGlobe();
  const bool isOnMap = IsOnMap(terrain.Frame, this->CoordinateType);
  positions.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    std::array<double, 3> point;
    input->GetPoint(static_cast<vtkIdType>(i), point.data());
    if (globe && this->CoordinateType == WORLD)
    {
      point = globe->GetFrame().ToGeographic(point);
    }
    positions[i] = { { point[0], point[1] } };
    if (isOnMap)
    {
      positions[i] = terrain.Frame.GetFrame().ToCoordinates(positions[i]);
    }
  }
  if (!isOnMap && this->CoordinateType != RASTER && !terrain.Pyramid->GeographicToRaster(positions))
  {
    return false;
  }
  for (MapPosition& position : positions)
  {
    position = GetSample(terrain.Frame.GetLattice().Describe(), position);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkTerrainClamp::ClampTo(
  const vtkTerrain& terrain, vtkPolyData* input, vtkPolyData* output)
{
  const relevo::RasterDescription& contents = terrain.Frame.GetLattice().Describe();
  std::vector<MapPosition> positions;
  if (!this->FindPositions(terrain, input, positions))
  {
    return std::string(terrain.Pyramid->GetFileName()) +
      " has no coordinate system, so there are no longitudes and latitudes. Call "
      "SetCoordinateTypeToRaster(), or give the file a coordinate system (gdal_translate -a_srs).";
  }
  relevo::TerrainDraping::Settings settings;
  settings.IsMirrored = contents.Location.FlipColumns != contents.Location.FlipRows;
  settings.Offset = this->Offset;
  settings.Period = IsOnMap(terrain.Frame, this->CoordinateType) ? MapPosition{ { 0.0, 0.0 } }
                                                                 : GetPeriod(contents);
  settings.IsAborted = [this] { return relevo::IsAborted(this); };
  relevo::TerrainDraping draping(terrain.Surface, settings, input, std::move(positions));
  if (draping.Run(output) == relevo::TerrainDraping::Result::TooManyCells)
  {
    return "The input has too many parts on this terrain. Use a smaller input or a larger "
           "MaximumError.";
  }
  const std::string warning = draping.HasLeftOut()
    ? "Parts of the input are outside of the raster or over missing data. They are left out."
    : "";
  if (relevo::ShouldReport(this->Warning, warning))
  {
    vtkWarningMacro(<< warning);
  }
  return "";
}

//------------------------------------------------------------------------------
void vtkTerrainClamp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper: " << this->Mapper.Get() << "\n";
  os << indent << "Pyramid: " << this->Pyramid.Get() << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "CoordinateType: " << this->CoordinateType << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
}
