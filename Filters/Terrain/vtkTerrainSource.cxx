// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainSource.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#if RELEVO_HAS_GDAL
#include "Geodesy/CoordinateSystem.h"
#endif
#include "Geodesy/LocationArrays.h"
#include "Geodesy/TerrainFrame.h"
#include "Heights/TerrainMesh.h"
#include "Raster/ImageryTexture.h"
#include "Raster/RasterFile.h"
#include "vtkCommand.h"
#include "vtkDisplacement.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace
{
// Fractions of the progress.
constexpr double HeightsShare = 0.6;
constexpr double MeshShare = 0.1;

constexpr int LargestImagerySize = 65536; // pixels per side
constexpr double LargestExaggeration = VTK_FLOAT_MAX;
}

vtkStandardNewMacro(vtkTerrainSource);

vtkTerrainSource::vtkTerrainSource()
  : ImageryFileName(nullptr)
  , ImageryBands{ 0, 0, 0 }
  , MaximumImagerySize(4096)
  , Resolution(128)
  , AlignToSamples(false)
  , Exaggeration(1.0)
  , Origin{ 0.0, 0.0, 0.0 }
  , KeepHeights(true)
  , VerticalUnit(1.0)
{
  this->SetNumberOfInputPorts(0);
  this->HeightMap->AddObserver(vtkCommand::ErrorEvent, this, &vtkTerrainSource::ForwardError);
  this->HeightMap->AddObserver(vtkCommand::WarningEvent, this, &vtkTerrainSource::ForwardWarning);
  this->HeightMap->AddObserver(vtkCommand::ProgressEvent, this, &vtkTerrainSource::ForwardProgress);
  this->Displacement->SetHeightMap(this->HeightMap);
  this->Displacement->SetDirection(0.0, 0.0, 1.0);
}

vtkTerrainSource::~vtkTerrainSource()
{
  this->SetImageryFileName(nullptr);
}

void vtkTerrainSource::SetFileName(const char* fileName)
{
  this->HeightMap->SetFileName(fileName); // its modification time is part of that of this object
}

char* vtkTerrainSource::GetFileName()
{
  return this->HeightMap->GetFileName();
}

void vtkTerrainSource::SetImageryBands(int red, int green, int blue)
{
  const int bands[3] = { red, green, blue };
  const bool isDefault = red == 0 && green == 0 && blue == 0;
  if (!isDefault && std::any_of(bands, bands + 3, [](int band) { return band < 1; }))
  {
    vtkErrorMacro(<< "ImageryBands must be three bands, counted from 1, or (0, 0, 0), got (" << red
                  << ", " << green << ", " << blue << ").");
    return;
  }
  if (!std::equal(bands, bands + 3, this->ImageryBands))
  {
    std::copy_n(bands, 3, this->ImageryBands);
    this->Modified();
  }
}

void vtkTerrainSource::SetMaximumImagerySize(int pixels)
{
  relevo::SetInRange(
    this, "MaximumImagerySize", this->MaximumImagerySize, pixels, 1, LargestImagerySize);
}

void vtkTerrainSource::SetResolution(int squares)
{
  relevo::SetInRange(this, "Resolution", this->Resolution, squares, 1, VTK_INT_MAX);
}

void vtkTerrainSource::SetExaggeration(double exaggeration)
{
  if (relevo::CheckRange(
        this, "Exaggeration", exaggeration, -LargestExaggeration, LargestExaggeration) &&
    this->Exaggeration != exaggeration)
  {
    this->Exaggeration = exaggeration;
    this->Displacement->SetScale(exaggeration * this->VerticalUnit);
    this->Modified();
  }
}

void vtkTerrainSource::SetNoDataValue(double value)
{
  this->HeightMap->SetNoDataValue(value);
}

double vtkTerrainSource::GetNoDataValue()
{
  return this->HeightMap->GetNoDataValue();
}

void vtkTerrainSource::UnsetNoDataValue()
{
  this->HeightMap->UnsetNoDataValue();
}

void vtkTerrainSource::SetMaximumDimension(int dimension)
{
  if (relevo::CheckRange(this, "MaximumDimension", dimension, 0, VTK_INT_MAX))
  {
    this->HeightMap->SetMaximumDimension(dimension);
  }
}

int vtkTerrainSource::GetMaximumDimension()
{
  return this->HeightMap->GetMaximumDimension();
}

void vtkTerrainSource::SetNoDataPolicy(int policy)
{
  if (relevo::CheckChoice(this, "NoDataPolicy", policy, { "HOLE", "FILL" }) &&
    this->GetNoDataPolicy() != policy)
  {
    this->Displacement->SetNoDataPolicy(policy);
    this->Modified();
  }
}

int vtkTerrainSource::GetNoDataPolicy()
{
  return this->Displacement->GetNoDataPolicy();
}

void vtkTerrainSource::SetNoDataPolicyToHole()
{
  this->SetNoDataPolicy(vtkDisplacement::HOLE);
}

void vtkTerrainSource::SetNoDataPolicyToFill()
{
  this->SetNoDataPolicy(vtkDisplacement::FILL);
}

vtkDisplacement* vtkTerrainSource::GetDisplacement()
{
  return this->Displacement;
}

vtkHeightMap* vtkTerrainSource::GetHeightMap()
{
  return this->HeightMap;
}

vtkImageData* vtkTerrainSource::GetImagery()
{
  return this->ImageryFileName ? this->Imagery.Get() : nullptr;
}

const char* vtkTerrainSource::GetCoordinateSystem()
{
  return this->CoordinateSystem.c_str();
}

bool vtkTerrainSource::IsGeographic()
{
  return this->Frame && this->Frame->IsGeographic();
}

bool vtkTerrainSource::TerrainToMap(const double terrain[3], double map[3])
{
  std::array<double, 2> coordinates;
  if (!this->Frame || !this->Frame->ToCoordinates({ terrain[0], terrain[1] }, coordinates))
  {
    return false;
  }
  std::copy_n(coordinates.data(), 2, map);
  const double scale = this->Displacement->GetScale();
  map[2] = scale != 0.0 ? terrain[2] / scale : 0.0;
  return true;
}

bool vtkTerrainSource::MapToTerrain(const double map[3], double terrain[3])
{
  std::array<double, 2> place;
  if (!this->Frame || !this->Frame->ToPlace({ map[0], map[1] }, place))
  {
    return false;
  }
  std::copy_n(place.data(), 2, terrain);
  terrain[2] = map[2] * this->Displacement->GetScale();
  return true;
}

bool vtkTerrainSource::GeographicToTerrain(const double geographic[3], double terrain[3])
{
#if RELEVO_HAS_GDAL
  std::array<double, 2> place = { geographic[0], geographic[1] };
  if (this->CoordinateSystem.empty() || !relevo::GeographicToSystem(this->CoordinateSystem, place))
  {
    return false;
  }
  const double map[3] = { place[0], place[1], geographic[2] };
  return this->MapToTerrain(map, terrain);
#else
  static_cast<void>(geographic);
  static_cast<void>(terrain);
  return false;
#endif
}

vtkMTimeType vtkTerrainSource::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->HeightMap->GetMTime());
}

void vtkTerrainSource::ForwardError(vtkObject*, unsigned long, void*)
{
  vtkErrorMacro(<< this->HeightMap->GetErrorMessage());
}

void vtkTerrainSource::ForwardWarning(vtkObject*, unsigned long, void*)
{
  vtkWarningMacro(<< this->HeightMap->GetWarningMessage());
}

void vtkTerrainSource::ForwardProgress(vtkObject*, unsigned long, void* progress)
{
  this->UpdateProgress(HeightsShare * *static_cast<double*>(progress));
  if (relevo::IsAborted(this))
  {
    this->HeightMap->AbortExecuteOn();
  }
}

int vtkTerrainSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->CoordinateSystem.clear();
  this->Frame.reset();
  std::fill_n(this->Origin, 3, 0.0);
  std::string error;
  bool isBuilt = false;
  if (!relevo::FitsMemory([&] { isBuilt = this->Build(output, error); }))
  {
    error = "Not enough memory for a mesh of Resolution " + std::to_string(this->Resolution) +
      " and imagery of up to " + std::to_string(this->MaximumImagerySize) + " pixels per side.";
  }
  if (isBuilt)
  {
    if (!this->KeepHeights)
    {
      this->HeightMap->ReleaseHeights();
    }
    this->UpdateProgress(1.0);
    return 1;
  }
  output->Initialize();
  this->CoordinateSystem.clear();
  this->Frame.reset();
  std::fill_n(this->Origin, 3, 0.0);
  this->Imagery->Initialize();
  this->ImageryState.clear();
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  return relevo::IsAborted(this) ? 1 : 0; // otherwise the height map has reported the error
}

bool vtkTerrainSource::Build(vtkPolyData* output, std::string& error)
{
  if (!this->HeightMap->GetImageData() && (!this->GetFileName() || !*this->GetFileName()))
  {
    error = "There is no file name: call SetFileName().";
    return false;
  }
  // Errors in the headers are reported before the heights are read, which can take long.
  if (!this->HeightMap->UpdateInformation())
  {
    return false;
  }
  const relevo::Georeference location = this->HeightMap->Describe().Location;
  const double verticalUnit = this->HeightMap->Describe().VerticalUnit;
  if (!this->CheckLocation(location, error) || !this->CheckImagery(error))
  {
    return false;
  }
  this->SetProgressText("reading heights");
  this->UpdateProgress(0.0);
  if (!this->HeightMap->Update())
  {
    return false;
  }
  const int* texels = this->HeightMap->GetDimensions();
  this->Frame.reset(new relevo::TerrainFrame(location));
  this->VerticalUnit = verticalUnit;
  this->Displacement->SetScale(this->Exaggeration * this->VerticalUnit);
  this->CoordinateSystem = location.WKT;
  std::copy_n(this->Frame->GetCenter().data(), 2, this->Origin);

  const bool hasHoles = this->GetNoDataPolicy() == vtkDisplacement::HOLE;
  if (!relevo::BuildTerrainMesh(
        *this->Frame, texels, this->Resolution, this->AlignToSamples,
        hasHoles ? this->HeightMap->GetValidity() : nullptr,
        [this] { return !relevo::IsAborted(this); }, output))
  {
    return false;
  }
  relevo::AddLocationArrays(this->Origin, this->CoordinateSystem, output);
  this->UpdateProgress(HeightsShare + MeshShare);
  return !relevo::IsAborted(this) && this->UpdateImagery(location, error);
}

bool vtkTerrainSource::CheckLocation(const relevo::Georeference& location, std::string& error)
{
  if (this->HeightMap->GetImageData())
  {
    return true;
  }
  const std::string name = this->GetFileName();
#if !RELEVO_HAS_GDAL
  vtkWarningMacro(<< "This build of Relevo does not have GDAL. A georeference of " << name
                  << " is not read, and one texel is one unit.");
#endif
  const std::string reason = relevo::FindLocationError(location);
  if (!reason.empty())
  {
    error = name + reason;
    return false;
  }
  this->WarnOfLocation(location);
  return true;
}

void vtkTerrainSource::WarnOfLocation(const relevo::Georeference& location)
{
  const std::string warning =
    relevo::FindLocationWarning(location, this->HeightMap->GetFullDimensions());
  if (!warning.empty())
  {
    vtkWarningMacro(<< this->GetFileName() << warning);
  }
}

bool vtkTerrainSource::CheckImagery(std::string& error)
{
  if (!this->ImageryFileName || !*this->ImageryFileName)
  {
    return true;
  }
  if (!relevo::OpenRaster(this->ImageryFileName, error))
  {
    error = "Cannot drape " + std::string(this->ImageryFileName) + ": " + error + ".";
    return false;
  }
  return true;
}

bool vtkTerrainSource::UpdateImagery(const relevo::Georeference& location, std::string& error)
{
  if (!this->ImageryFileName || !*this->ImageryFileName)
  {
    this->Imagery->Initialize();
    this->ImageryState.clear();
    return true;
  }
  std::ostringstream state;
  state << this->ImageryFileName << '\n' << this->MaximumImagerySize;
  for (int band : this->ImageryBands)
  {
    state << ' ' << band;
  }
  if (this->ImageryState == state.str() && this->ImageryTime > this->HeightMap->GetSamplesMTime())
  {
    return true;
  }

  this->SetProgressText("draping imagery");
  this->UpdateProgress(HeightsShare + MeshShare);
  relevo::ImagerySource source;
  source.FileName = this->ImageryFileName;
  std::copy_n(this->ImageryBands, 3, source.Bands.begin());
  source.MaximumSize = this->MaximumImagerySize;
  const auto progress = [this](double share)
  {
    this->UpdateProgress(HeightsShare + MeshShare + (1.0 - HeightsShare - MeshShare) * share);
    return !relevo::IsAborted(this);
  };
  std::string warning;
  if (!relevo::MakeImageryTexture(source, location, this->Imagery, progress, warning, error))
  {
    return false;
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning
                    << " For full detail, crop the terrain (gdal_translate -srcwin), or raise "
                    << "MaximumImagerySize if textures may be that large.");
  }
  this->ImageryTime.Modified();
  this->ImageryState = state.str();
  return true;
}

void vtkTerrainSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->GetFileName() ? this->GetFileName() : "(none)") << "\n";
  os << indent << "ImageryFileName: " << (this->ImageryFileName ? this->ImageryFileName : "(none)")
     << "\n";
  os << indent << "ImageryBands: " << this->ImageryBands[0] << ", " << this->ImageryBands[1] << ", "
     << this->ImageryBands[2] << "\n";
  os << indent << "MaximumImagerySize: " << this->MaximumImagerySize << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "AlignToSamples: " << (this->AlignToSamples ? "on" : "off") << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "KeepHeights: " << (this->KeepHeights ? "On\n" : "Off\n");
  os << indent << "Origin: " << this->Origin[0] << ", " << this->Origin[1] << ", "
     << this->Origin[2] << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "HeightMap:\n";
  this->HeightMap->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Displacement:\n";
  this->Displacement->PrintSelf(os, indent.GetNextIndent());
}
