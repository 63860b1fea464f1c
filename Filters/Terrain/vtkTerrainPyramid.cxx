// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPyramid.h"

#include "Checks/SettingChecks.h"
#include "Geodesy/Georeference.h"
#include "Geodesy/MapFrame.h"
#include "Geodesy/TerrainFrame.h"
#include "Lattice/HeightLattice.h"
#include "Lattice/SampleDoubts.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
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

// The range of a region that does not repeat; the first height is larger if there are no data.
relevo::ElevationRanges::Range FindRange(
  const relevo::HeightLattice& lattice, const double region[4])
{
  const relevo::RasterDescription& contents = lattice.Describe();
  const relevo::Georeference& location = contents.Location;
  std::array<std::array<double, 2>, 2> window;
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::array<double, 2> uv =
      location.Parameters({ { region[corner % 2], region[2 + corner / 2] } });
    const double samples[2] = { (location.FlipColumns ? 1.0 - uv[0] : uv[0]) * contents.Width - 0.5,
      (location.FlipRows ? 1.0 - uv[1] : uv[1]) * contents.Height - 0.5 };
    for (int axis = 0; axis < 2; ++axis)
    {
      std::array<double, 2>& side = window[axis];
      side[0] = corner == 0 ? samples[axis] : std::min(side[0], samples[axis]);
      side[1] = corner == 0 ? samples[axis] : std::max(side[1], samples[axis]);
    }
  }
  double longest = 1.0; // in tiles
  for (int axis = 0; axis < 2; ++axis)
  {
    const double last = (axis == 0 ? contents.Width : contents.Height) - 1.0;
    std::array<double, 2>& side = window[axis];
    if (!(side[1] >= -0.5 && side[0] <= last + 0.5))
    {
      return { { 1.0f, 0.0f } };
    }
    side = { { std::clamp(side[0], 0.0, last), std::clamp(side[1], 0.0, last) } };
    longest = std::max(longest, (side[1] - side[0]) / relevo::ElevationRanges::SamplesPerTile);
  }
  const int level = static_cast<int>(std::ceil(std::log2(longest)));
  return lattice.GetRanges()->Get(level, window[0], window[1]);
}

// Whether a point in units of the raster's sides is in it.
bool IsInside(const std::array<double, 2>& uv)
{
  return std::all_of(uv.begin(), uv.end(),
    [](double c) { return c >= -BorderTolerance && c <= 1.0 + BorderTolerance; });
}
}

vtkStandardNewMacro(vtkTerrainPyramid);

//------------------------------------------------------------------------------
vtkTerrainPyramid::vtkTerrainPyramid()
  : FileName(nullptr)
  , CacheDirectory(nullptr)
  , MemoryLimit(vtkTypeInt64(1) << 28)
  , IndexMemoryLimit(0)
  , AbortExecute(false)
  , HasReportedIndex(false)
  , Dimensions{ 0, 0 }
  , Range{ 0.0, 0.0 }
  , Bounds{ 1.0, -1.0, 1.0, -1.0 }
{
}

//------------------------------------------------------------------------------
vtkTerrainPyramid::~vtkTerrainPyramid()
{
  delete[] this->FileName;
  delete[] this->CacheDirectory;
}

//------------------------------------------------------------------------------
void vtkTerrainPyramid::SetIndexMemoryLimit(vtkTypeInt64 bytes)
{
  relevo::SetInRange<vtkTypeInt64>(
    this, "IndexMemoryLimit", this->IndexMemoryLimit, bytes, 0, VTK_TYPE_INT64_MAX);
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
bool vtkTerrainPyramid::ReportOpening(const std::string& error)
{
  if (error != this->OpeningError)
  {
    this->OpeningError = error;
    return this->Report(error);
  }
  this->ErrorMessage = error;
  return false;
}

//------------------------------------------------------------------------------
double* vtkTerrainPyramid::GetRange()
{
  this->GetRange(this->Range);
  return this->Range;
}

//------------------------------------------------------------------------------
const relevo::RasterDescription* vtkTerrainPyramid::Describe() const
{
  return this->Lattice ? &this->Lattice->Describe() : nullptr;
}

//------------------------------------------------------------------------------
void vtkTerrainPyramid::GetBounds(double bounds[4])
{
  const std::array<double, 4> none = { { 1.0, -1.0, 1.0, -1.0 } };
  std::copy(none.begin(), none.end(), bounds);
  const relevo::RasterDescription* contents = this->Describe();
  for (int corner = 0; contents && corner < 4; ++corner)
  {
    const std::array<double, 2> place = contents->Location.Coordinates(corner % 2, corner / 2);
    for (int axis = 0; axis < 2; ++axis)
    {
      double* range = bounds + 2 * axis;
      range[0] = corner == 0 ? place[axis] : std::min(range[0], place[axis]);
      range[1] = corner == 0 ? place[axis] : std::max(range[1], place[axis]);
    }
  }
}

//------------------------------------------------------------------------------
double* vtkTerrainPyramid::GetBounds()
{
  this->GetBounds(this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::RasterToSample(const double coordinates[2], double sample[2])
{
  const relevo::RasterDescription* contents = this->Describe();
  if (!contents)
  {
    return false;
  }
  const relevo::Georeference& location = contents->Location;
  std::array<double, 2> uv = location.Parameters({ { coordinates[0], coordinates[1] } });
  if (location.System == relevo::Georeference::Kind::Geographic && !IsInside(uv))
  {
    const double turn = 360.0 / location.Unit;
    for (const double shift : { turn, -turn })
    {
      const std::array<double, 2> moved =
        location.Parameters({ { coordinates[0] + shift, coordinates[1] } });
      uv = IsInside(moved) ? moved : uv;
    }
  }
  const double u = location.FlipColumns ? 1.0 - uv[0] : uv[0];
  const double v = location.FlipRows ? 1.0 - uv[1] : uv[1];
  sample[0] = u * contents->Width - 0.5;
  sample[1] = v * contents->Height - 0.5;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::SampleToRaster(const double sample[2], double coordinates[2])
{
  const relevo::RasterDescription* contents = this->Describe();
  if (!contents)
  {
    return false;
  }
  const double u = (sample[0] + 0.5) / contents->Width;
  const double v = (sample[1] + 0.5) / contents->Height;
  const relevo::Georeference& location = contents->Location;
  const std::array<double, 2> place =
    location.Coordinates(location.FlipColumns ? 1.0 - u : u, location.FlipRows ? 1.0 - v : v);
  std::copy(place.begin(), place.end(), coordinates);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::RasterToMap(const double raster[3], double map[3])
{
  const relevo::RasterDescription* contents = this->Describe();
  if (!contents)
  {
    return false;
  }
  const std::array<double, 2> place =
    relevo::MapFrame(contents->Location).ToMap({ { raster[0], raster[1] } });
  map[2] = raster[2] * contents->VerticalUnit;
  std::copy(place.begin(), place.end(), map);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::MapToRaster(const double map[3], double raster[3])
{
  const relevo::RasterDescription* contents = this->Describe();
  if (!contents)
  {
    return false;
  }
  const std::array<double, 2> coordinates =
    relevo::MapFrame(contents->Location).ToCoordinates({ { map[0], map[1] } });
  raster[2] = map[2] / contents->VerticalUnit;
  std::copy(coordinates.begin(), coordinates.end(), raster);
  return true;
}

//------------------------------------------------------------------------------
// The column and row of a point, whole numbers at the centres of samples; NaN outside.
std::array<double, 2> vtkTerrainPyramid::ToSamples(double x, double y)
{
  const double place[2] = { x, y };
  std::array<double, 2> sample;
  const bool isInside = this->RasterToSample(place, sample.data()) &&
    IsInside(
      { { (sample[0] + 0.5) / this->Dimensions[0], (sample[1] + 0.5) / this->Dimensions[1] } });
  return isInside ? sample : std::array<double, 2>{ { NoHeight, NoHeight } };
}
//------------------------------------------------------------------------------
bool vtkTerrainPyramid::GetRangeOfRegion(const double region[4], double range[2])
{
  const relevo::RasterDescription* contents = this->Describe();
  if (!contents)
  {
    return false;
  }
  // A region across the antimeridian is at both ends of a global raster.
  const double turn = this->IsGeographic() ? 360.0 / contents->Location.Unit : 0.0;
  bool isFound = false;
  for (int shift = turn > 0.0 ? -1 : 0; shift <= (turn > 0.0 ? 1 : 0); ++shift)
  {
    const double moved[4] = { region[0] + shift * turn, region[1] + shift * turn, region[2],
      region[3] };
    const relevo::ElevationRanges::Range found = FindRange(*this->Lattice, moved);
    if (found[0] <= found[1])
    {
      range[0] = isFound ? std::min<double>(range[0], found[0]) : found[0];
      range[1] = isFound ? std::max<double>(range[1], found[1]) : found[1];
      isFound = true;
    }
  }
  return isFound;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::IsGeographic()
{
  const relevo::RasterDescription* contents = this->Describe();
  return contents && contents->Location.System == relevo::Georeference::Kind::Geographic;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::HasGeoreference()
{
  const relevo::RasterDescription* contents = this->Describe();
  return contents && contents->Location.System != relevo::Georeference::Kind::None;
}

//------------------------------------------------------------------------------
double vtkTerrainPyramid::GetVerticalUnit()
{
  const relevo::RasterDescription* contents = this->Describe();
  return contents ? contents->VerticalUnit : 1.0;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramid::IsPicture()
{
  const relevo::RasterDescription* contents = this->Describe();
  return contents && contents->IsPicture;
}

//------------------------------------------------------------------------------
const char* vtkTerrainPyramid::GetLocationWarning()
{
  const relevo::RasterDescription* contents = this->Describe();
  this->LocationWarning =
    contents ? relevo::FindLocationWarning(contents->Location, this->Dimensions) : "";
  return this->LocationWarning.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTerrainPyramid::GetSampleWarning()
{
  constexpr int size = 257; // samples per side that are compared with the ends of the range
  this->SampleWarning.clear();
  const relevo::RasterDescription* contents = this->Describe();
  if (!contents)
  {
    return this->SampleWarning.c_str();
  }
  this->SampleWarning = relevo::FindPhotoWarning(*this->Lattice);
  std::array<double, 2> range;
  this->GetRange(range.data());
  const auto isMarker = [contents](double height)
  { return relevo::IsMarker((height - contents->Offset) / contents->Scale); };
  if (this->SampleWarning.empty() && std::any_of(range.begin(), range.end(), isMarker))
  {
    const auto image = vtkSmartPointer<vtkImageData>::Take(this->GetReducedElevations(size));
    if (image)
    {
      this->SampleWarning = relevo::FindMarkerWarning(*contents, range,
        static_cast<const float*>(image->GetScalarPointer()),
        static_cast<std::size_t>(image->GetNumberOfPoints()));
    }
  }
  return this->SampleWarning.c_str();
}

//------------------------------------------------------------------------------
double vtkTerrainPyramid::GetNearestElevation(double x, double y)
{
  const double place[2] = { x, y };
  double sample[2];
  if (!this->RasterToSample(place, sample))
  {
    this->Report("There is no raster to read heights from: call Update() first.");
    return NoHeight;
  }
  const double column = std::round(sample[0]);
  const double row = std::round(sample[1]);
  if (!(column >= 0.0 && row >= 0.0 && column < this->Dimensions[0] && row < this->Dimensions[1]))
  {
    return NoHeight;
  }
  float height = 0.0f;
  std::string error;
  if (!this->Lattice->ReadWindow(
        0, static_cast<int>(column), static_cast<int>(row), 1, 1, &height, error))
  {
    this->Report("Cannot read " + this->OpenedName + ": " + error + ".");
    return NoHeight;
  }
  return height;
}

//------------------------------------------------------------------------------
vtkImageData* vtkTerrainPyramid::GetReducedElevations(int size)
{
  if (!this->Lattice || size < 2)
  {
    this->Report(this->Lattice ? "GetReducedElevations() needs a size of at least 2."
                               : "There is no raster to read heights from: call Update() first.");
    return nullptr;
  }
  int level = 0;
  const auto count = [&level](int samples) { return ((samples - 1) >> level) + 1; };
  while (std::max(count(this->Dimensions[0]), count(this->Dimensions[1])) > size)
  {
    ++level;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(count(this->Dimensions[0]), count(this->Dimensions[1]), 1);
  const double spacing = std::ldexp(1.0, level);
  image->SetSpacing(spacing, spacing, 1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->SetName("Elevation");
  std::string error;
  if (!this->Lattice->ReadWindow(level, 0, 0, image->GetDimensions()[0], image->GetDimensions()[1],
        static_cast<float*>(image->GetScalarPointer()), error))
  {
    this->Report("Cannot read " + this->OpenedName + ": " + error + ".");
    return nullptr;
  }
  image->Register(this);
  return image;
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
      return this->ReportOpening("There is no raster to open: call SetFileName().");
    }
    std::string error;
    this->Pyramid = relevo::RasterPyramid::Open(name, folder, error, this->IndexMemoryLimit);
    if (!this->Pyramid)
    {
      return this->ReportOpening("Cannot open " + name + ": " + error + ".");
    }
    this->OpeningError.clear();
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
bool vtkTerrainPyramid::HasIndexEnded()
{
  return !this->Pyramid || this->Pyramid->HasIndexEnded();
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
  return this->ReportOpening(
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
bool vtkTerrainPyramid::HasIndexEnded()
{
  return true;
}
bool vtkTerrainPyramid::WaitForIndex()
{
  return this->Update();
}
double vtkTerrainPyramid::GetMaximumError(int)
{
  return std::numeric_limits<double>::infinity();
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
  os << indent << "IndexMemoryLimit: " << this->IndexMemoryLimit << "\n";
  os << indent << "AbortExecute: " << this->AbortExecute << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " x " << this->Dimensions[1] << "\n";
  os << indent << "NumberOfLevels: " << this->GetNumberOfLevels() << "\n";
  os << indent << "IsErrorKnown: " << this->IsErrorKnown() << "\n";
}
