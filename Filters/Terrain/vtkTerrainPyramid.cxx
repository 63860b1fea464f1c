// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPyramid.h"

#include "Geodesy/Georeference.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#if RELEVO_HAS_GDAL
#include "Geodesy/CoordinateSystem.h"
#include "Pyramid/PyramidLattice.h"
#include "Pyramid/RasterPyramid.h"
#else
namespace relevo
{
class RasterPyramid
{
};
}
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace
{
constexpr double NoHeight = std::numeric_limits<double>::quiet_NaN();
constexpr vtkTypeInt64 MinimumLimit = 1 << 20;

// Coordinates at the border of the raster are inside in spite of rounding.
constexpr double BorderTolerance = 1e-9;
}

vtkStandardNewMacro(vtkTerrainPyramid);

//------------------------------------------------------------------------------
vtkTerrainPyramid::vtkTerrainPyramid()
  : FileName(nullptr)
  , CacheDirectory(nullptr)
  , MemoryLimit(vtkTypeInt64(1) << 28)
  , AbortExecute(false)
  , HasReportedIndex(false)
  , Dimensions{ 0, 0 }
  , Range{ 0.0, 0.0 }
{
}

//------------------------------------------------------------------------------
vtkTerrainPyramid::~vtkTerrainPyramid()
{
  delete[] this->FileName;
  delete[] this->CacheDirectory;
}

//------------------------------------------------------------------------------
void vtkTerrainPyramid::SetMemoryLimit(vtkTypeInt64 bytes)
{
  if (bytes < MinimumLimit)
  {
    vtkErrorMacro(<< "MemoryLimit must be at least " << MinimumLimit << ", got " << bytes << ".");
    return;
  }
  if (bytes == this->MemoryLimit)
  {
    return;
  }
  this->MemoryLimit = bytes;
#if RELEVO_HAS_GDAL
  if (this->Pyramid)
  {
    this->Pyramid->GetCache().SetLimit(static_cast<std::size_t>(bytes));
  }
#endif
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::Report(const std::string& error)
{
  // Queries of several threads can fail at once.
  const std::lock_guard<std::recursive_mutex> lock(this->ReportMutex);
  this->ErrorMessage = error;
  vtkErrorMacro(<< error);
  return false;
}

//------------------------------------------------------------------------------
double* vtkTerrainPyramid::GetRange()
{
  this->GetRange(this->Range);
  return this->Range;
}

#if RELEVO_HAS_GDAL
//------------------------------------------------------------------------------
bool vtkTerrainPyramid::Update()
{
  const std::string name = this->FileName ? this->FileName : "";
  const std::string folder = this->CacheDirectory ? this->CacheDirectory : "";
  const bool isOpen = this->Pyramid && name == this->OpenedName &&
    folder == this->OpenedCacheDirectory &&
    this->Pyramid->GetFile().GetSignature() == this->Pyramid->GetSignature();
  if (!isOpen)
  {
    this->Pyramid.reset();
    this->Lattice.reset();
    std::fill_n(this->Dimensions, 2, 0);
    this->HasReportedIndex = false;
    this->ErrorMessage.clear();
    if (name.empty())
    {
      return this->Report("There is no raster to open: call SetFileName().");
    }
    std::string error;
    this->Pyramid = relevo::RasterPyramid::Open(name, folder, error);
    if (!this->Pyramid)
    {
      return this->Report("Cannot open " + name + ": " + error + ".");
    }
    this->Lattice = std::make_shared<relevo::PyramidLattice>(this->Pyramid);
    this->OpenedName = name;
    this->OpenedCacheDirectory = folder;
    this->Pyramid->GetCache().SetLimit(static_cast<std::size_t>(this->MemoryLimit));
    const std::array<int, 2>& size = this->Pyramid->GetFile().GetSize(0);
    std::copy(size.begin(), size.end(), this->Dimensions);
    this->Modified();
  }
  const std::string error = this->Pyramid->GetIndexError();
  if (!error.empty() && !this->HasReportedIndex)
  {
    this->HasReportedIndex = true;
    return this->Report("Cannot read " + name + ": " + error + ".");
  }
  return error.empty();
}

//------------------------------------------------------------------------------
int vtkTerrainPyramid::GetNumberOfLevels()
{
  return this->Pyramid ? this->Pyramid->GetFile().GetNumberOfLevels() : 0;
}

//------------------------------------------------------------------------------
void vtkTerrainPyramid::GetLevelDimensions(int level, int dimensions[2])
{
  std::fill_n(dimensions, 2, 0);
  if (level >= 0 && level < this->GetNumberOfLevels())
  {
    const std::array<int, 2>& size = this->Pyramid->GetFile().GetSize(level);
    std::copy(size.begin(), size.end(), dimensions);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainPyramid::GetRange(double range[2])
{
  std::fill_n(range, 2, 0.0);
  if (this->Pyramid)
  {
    const std::array<double, 2>& estimate = this->Pyramid->GetEstimatedRange();
    std::copy(estimate.begin(), estimate.end(), range);
  }
  double samples[2];
  if (this->IsErrorKnown() && this->Pyramid->GetIndex().GetRange(0, samples))
  {
    const relevo::RasterDescription& contents = this->Pyramid->GetFile().Describe();
    for (int i = 0; i < 2; ++i)
    {
      range[i] = contents.Scale * samples[i] + contents.Offset;
    }
    std::sort(range, range + 2);
  }
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::IsErrorKnown()
{
  return this->Pyramid && this->Pyramid->IsIndexComplete();
}

//------------------------------------------------------------------------------
double vtkTerrainPyramid::GetIndexProgress()
{
  return this->Pyramid ? this->Pyramid->GetProgress() : 0.0;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::WaitForIndex()
{
  if (!this->Pyramid)
  {
    return this->Report("There is no index to wait for: call Update() first.");
  }
  this->AbortExecute = false;
  const std::string error = this->Pyramid->WaitForIndex(
    [this]()
    {
      double progress = this->Pyramid->GetProgress();
      this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
      return this->AbortExecute;
    });
  if (!error.empty() && !this->HasReportedIndex)
  {
    this->HasReportedIndex = true;
    return this->Report("Cannot read " + this->OpenedName + ": " + error + ".");
  }
  return error.empty() && this->IsErrorKnown();
}

//------------------------------------------------------------------------------
double vtkTerrainPyramid::GetMaximumError(int level)
{
  if (!this->IsErrorKnown() || level < 0 || level >= this->GetNumberOfLevels())
  {
    return std::numeric_limits<double>::infinity();
  }
  return std::abs(this->Pyramid->GetFile().Describe().Scale) *
    this->Pyramid->GetIndex().GetMaximumDeviation(level);
}

//------------------------------------------------------------------------------
// The column and row of a point, whole numbers at the centres of samples; NaN outside.
std::array<double, 2> vtkTerrainPyramid::ToSamples(double x, double y)
{
  const relevo::RasterDescription& contents = this->Pyramid->GetFile().Describe();
  const relevo::Georeference& location = contents.Location;
  const auto isInside = [](const std::array<double, 2>& uv)
  {
    return std::all_of(uv.begin(), uv.end(),
      [](double c) { return c >= -BorderTolerance && c <= 1.0 + BorderTolerance; });
  };
  std::array<double, 2> uv = location.Parameters({ { x, y } });
  if (location.System == relevo::Georeference::Kind::Geographic)
  {
    const double turn = 360.0 / location.Unit;
    for (const double shift : { turn, -turn })
    {
      uv = isInside(uv) ? uv : location.Parameters({ { x + shift, y } });
    }
  }
  if (!isInside(uv))
  {
    return { { NoHeight, NoHeight } };
  }
  const double u = location.FlipColumns ? 1.0 - uv[0] : uv[0];
  const double v = location.FlipRows ? 1.0 - uv[1] : uv[1];
  return { { u * contents.Width - 0.5, v * contents.Height - 0.5 } };
}

//------------------------------------------------------------------------------
double vtkTerrainPyramid::Evaluate(const std::array<double, 2>& place, std::string& error)
{
  if (std::isnan(place[0]))
  {
    return NoHeight;
  }
  const relevo::RasterDescription& contents = this->Pyramid->GetFile().Describe();
  double sample = NoHeight;
  this->Pyramid->Interpolate(place[0], place[1], sample, error);
  return contents.Scale * sample + contents.Offset;
}

//------------------------------------------------------------------------------
double vtkTerrainPyramid::GetElevation(double x, double y)
{
  if (!this->Pyramid)
  {
    this->Report("There is no raster to read heights from: call Update() first.");
    return NoHeight;
  }
  std::string error;
  const double height = this->Evaluate(this->ToSamples(x, y), error);
  if (!error.empty())
  {
    this->Report("Cannot read " + this->OpenedName + ": " + error + ".");
  }
  return height;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkTerrainPyramid::GetElevations(vtkDoubleArray* points)
{
  if (!this->Pyramid || !points || points->GetNumberOfComponents() != 2)
  {
    this->Report(!this->Pyramid ? "There is no raster to read heights from: call Update() first."
                                : "GetElevations() needs an array of 2 components, x and y.");
    return nullptr;
  }
  vtkDoubleArray* heights = vtkDoubleArray::New();
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(points->GetNumberOfTuples());
  std::vector<std::array<double, 2>> places(points->GetNumberOfTuples());
  std::vector<vtkIdType> order(places.size());
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    places[i] = this->ToSamples(points->GetTypedComponent(i, 0), points->GetTypedComponent(i, 1));
    order[i] = i;
  }
  // Each tile is read once, however the points are ordered.
  const auto getTile = [&places](vtkIdType i)
  {
    constexpr double size = 256.0; // about that of most files
    const auto& place = places[i];
    return std::isnan(place[0])
      ? std::array<double, 2>{ { -1.0, -1.0 } }
      : std::array<double, 2>{ { std::floor(place[1] / size), std::floor(place[0] / size) } };
  };
  std::stable_sort(order.begin(), order.end(),
    [&getTile](vtkIdType a, vtkIdType b) { return getTile(a) < getTile(b); });
  std::mutex mutex;
  std::string first;
  vtkSMPTools::For(0, points->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        const vtkIdType i = order[k];
        std::string error;
        heights->SetValue(i, this->Evaluate(places[i], error));
        if (!error.empty())
        {
          const std::lock_guard<std::mutex> lock(mutex);
          first = first.empty() ? error : first;
        }
      }
    });
  if (!first.empty())
  {
    this->Report("Cannot read " + this->OpenedName + ": " + first + ".");
  }
  return heights;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::GeographicToRaster(const double geographic[2], double coordinates[2])
{
  return this->Convert(relevo::GeographicToSystem, geographic, coordinates);
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::GeographicToRaster(std::vector<std::array<double, 2>>& points)
{
  const std::string system = this->GetCoordinateSystem();
  return !system.empty() && relevo::GeographicToSystem(system, points);
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::RasterToGeographic(const double coordinates[2], double geographic[2])
{
  return this->Convert(relevo::SystemToGeographic, coordinates, geographic);
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::Convert(
  bool (*convert)(const std::string&, std::array<double, 2>&), const double from[2], double to[2])
{
  const std::string system = this->GetCoordinateSystem();
  std::array<double, 2> point = { { from[0], from[1] } };
  if (system.empty() || !convert(system, point))
  {
    return false;
  }
  std::copy(point.begin(), point.end(), to);
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTerrainPyramid::GetResidentMemorySize()
{
  return this->Pyramid ? static_cast<vtkTypeInt64>(this->Pyramid->GetCache().GetMemorySize()) : 0;
}

//------------------------------------------------------------------------------
const char* vtkTerrainPyramid::GetCoordinateSystem()
{
  return this->Pyramid ? this->Pyramid->GetFile().Describe().Location.WKT.c_str() : "";
}

//------------------------------------------------------------------------------
const char* vtkTerrainPyramid::GetHeightUnit()
{
  if (!this->Pyramid)
  {
    return "";
  }
  const relevo::RasterDescription& contents = this->Pyramid->GetFile().Describe();
  const auto isUnit = [&contents](double metres)
  { return std::abs(contents.VerticalUnit - metres) < 1e-5 * metres; };
  if (isUnit(0.3048))
  {
    return "ft";
  }
  // Names that are not known have the factor 1, too.
  static const std::set<std::string> metres = { "m", "M", "metre", "meter", "metres", "meters",
    "Metre", "Meter" };
  const bool isMetre = contents.UnitName.empty() ? !contents.Location.WKT.empty()
                                                 : metres.count(contents.UnitName) > 0;
  return isMetre ? "m" : contents.UnitName.c_str();
}
#else
// Without GDAL there is never a raster.
bool vtkTerrainPyramid::Update()
{
  return this->Report(
    "This build of Relevo does not have GDAL. Install libgdal-dev and build again.");
}
int vtkTerrainPyramid::GetNumberOfLevels()
{
  return 0;
}
void vtkTerrainPyramid::GetLevelDimensions(int, int dimensions[2])
{
  std::fill_n(dimensions, 2, 0);
}
void vtkTerrainPyramid::GetRange(double range[2])
{
  std::fill_n(range, 2, 0.0);
}
bool vtkTerrainPyramid::IsErrorKnown()
{
  return false;
}
double vtkTerrainPyramid::GetIndexProgress()
{
  return 0.0;
}
bool vtkTerrainPyramid::WaitForIndex()
{
  return this->Update();
}
double vtkTerrainPyramid::GetMaximumError(int)
{
  return std::numeric_limits<double>::infinity();
}
std::array<double, 2> vtkTerrainPyramid::ToSamples(double, double)
{
  return { { NoHeight, NoHeight } };
}
double vtkTerrainPyramid::Evaluate(const std::array<double, 2>&, std::string&)
{
  return NoHeight;
}
double vtkTerrainPyramid::GetElevation(double, double)
{
  this->Update();
  return NoHeight;
}
vtkDoubleArray* vtkTerrainPyramid::GetElevations(vtkDoubleArray*)
{
  this->Update();
  return nullptr;
}
bool vtkTerrainPyramid::GeographicToRaster(const double[2], double[2])
{
  return false;
}
bool vtkTerrainPyramid::GeographicToRaster(std::vector<std::array<double, 2>>&)
{
  return false;
}
bool vtkTerrainPyramid::RasterToGeographic(const double[2], double[2])
{
  return false;
}
vtkTypeInt64 vtkTerrainPyramid::GetResidentMemorySize()
{
  return 0;
}
const char* vtkTerrainPyramid::GetCoordinateSystem()
{
  return "";
}
const char* vtkTerrainPyramid::GetHeightUnit()
{
  return "";
}
#endif

//------------------------------------------------------------------------------
void vtkTerrainPyramid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "CacheDirectory: " << (this->CacheDirectory ? this->CacheDirectory : "(none)")
     << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "AbortExecute: " << this->AbortExecute << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " x " << this->Dimensions[1] << "\n";
  os << indent << "NumberOfLevels: " << this->GetNumberOfLevels() << "\n";
  os << indent << "IsErrorKnown: " << this->IsErrorKnown() << "\n";
}
