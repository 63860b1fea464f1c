// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/AdaptiveTerrain.h"

#include "Bisection/ClosedLattice.h"
#include "Bisection/TerrainBisection.h"
#include "Bisection/TerrainDivision.h"
#include "Geodesy/TerrainFrame.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
// Seconds in which a tile becomes visible.
constexpr double FadeTime = 0.25;

// The errors of tiles for shading, as a share of the tolerance. Those of faces are larger.
constexpr double ShadingShare = 0.5;

// Fewer tiles are read at the same time under lower limits of memory.
constexpr std::int64_t MemoryPerRead = std::int64_t(1) << 25;

// If a view needs too many faces, its tolerance grows by this factor, then by its square, and so
// on.
constexpr double FirstReduction = 4.0;

// An estimated range does not hide what exceeds it.
ElevationRanges::Range Widen(const ElevationRanges::Range& range)
{
  const float margin = range[1] - range[0];
  return { { range[0] - margin, range[1] + margin } };
}

// The tolerance grows by this factor until the faces fit into memory, and shrinks again if there is
// space for twice as many.
const double CoarseningStep = std::sqrt(2.0);
constexpr double LargestCoarsening = 1e6;

// Faces can be partly outside of their share.
TerrainShare CoverFaces(const TerrainShare& share, const std::vector<TerrainFace>& faces)
{
  constexpr int corners[3][2] = { { 0, 0 }, { TerrainFace::Segments, 0 },
    { 0, TerrainFace::Segments } };
  TerrainShare cover = share;
  for (const TerrainFace& face : faces)
  {
    for (const auto& corner : corners)
    {
      const std::array<double, 2> sample = face.GetSample(corner[0], corner[1]);
      cover.Columns = { { std::min(cover.Columns[0], sample[0]),
        std::max(cover.Columns[1], sample[0]) } };
      cover.Rows = { { std::min(cover.Rows[0], sample[1]), std::max(cover.Rows[1], sample[1]) } };
    }
  }
  return cover;
}

double GetSeconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}
}

AdaptiveTerrain::AdaptiveTerrain(std::shared_ptr<const HeightLattice> lattice,
  std::shared_ptr<const ImageryLattice> imagery, bool isGeocentric)
  : Lattice(std::move(lattice))
  , Imagery(std::move(imagery))
  , Frame(this->Lattice->Describe().Location)
  , Globe(isGeocentric ? std::make_shared<GlobeShape>(this->Lattice->Describe().Location,
                           this->Lattice->Describe().Width, this->Lattice->Describe().Height)
                       : nullptr)
  , Closed(this->Globe && this->Globe->GetFrame().GetError().empty()
        ? std::make_shared<ClosedLattice>(this->Lattice, this->Globe)
        : nullptr)
  , Dimensions{ { this->Lattice->Describe().Width, this->Lattice->Describe().Height } }
  , Cache([source = this->Lattice, closed = this->Closed](HeightTile& tile, std::string& error)
      { return closed ? closed->Read(tile, error) : source->Read(tile, error); },
      [source = this->Imagery](ImageryTile& tile, std::string& error)
      { return source->Read(tile, error); })
{
  if (this->Globe)
  {
    this->Dimensions = this->Globe->GetDimensions();
  }
}

AdaptiveTerrain::~AdaptiveTerrain() = default;

std::string AdaptiveTerrain::FindLocationError() const
{
  const RasterDescription& contents = this->Lattice->Describe();
  const std::string error = FindSystemError(contents.Location);
  if (!error.empty())
  {
    return error;
  }
  if (contents.Width < 2 || contents.Height < 2)
  {
    return " has only one row or column of samples, between which there is no surface.";
  }
  // Some rasters of the whole earth reach half a sample beyond the poles.
  constexpr double largestLatitude = 91.0;
  for (int corner = 0; corner < 4 && contents.Location.System == Georeference::Kind::Geographic;
       ++corner)
  {
    const double latitude = contents.Location.Coordinates(corner % 2, corner / 2)[1];
    if (!(std::abs(latitude * contents.Location.Unit) <= largestLatitude))
    {
      return " has latitudes beyond the poles. Give the file the right georeference (gdal_edit.py "
             "-a_ullr).";
    }
  }
  if (this->Globe && !this->Globe->GetFrame().GetError().empty())
  {
    return this->Globe->GetFrame().GetError();
  }
  const TerrainPlacement placement = this->GetPlacement(1.0);
  const double area =
    placement.Column[0] * placement.Row[1] - placement.Column[1] * placement.Row[0];
  std::array<double, 2> corner;
  for (int axis = 0; axis < 2; ++axis)
  {
    corner[axis] = placement.Origin[axis] + (contents.Width - 1.0) * placement.Column[axis] +
      (contents.Height - 1.0) * placement.Row[axis];
  }
  const auto fits = [](double x) { return std::abs(x) <= std::numeric_limits<float>::max(); };
  if (!fits(corner[0]) || !fits(corner[1]) || !(std::abs(area) > 0.0))
  {
    return " has an invalid georeference: its corners coincide, or are out of the range of floats. "
           "Give the file the right georeference (gdal_edit.py -a_ullr).";
  }
  return "";
}

TerrainPlacement AdaptiveTerrain::GetPlacement(double exaggeration) const
{
  const RasterDescription& contents = this->Lattice->Describe();
  TerrainPlacement placement =
    this->Frame.GetPlacement(contents.Width, contents.Height, contents.VerticalUnit * exaggeration);
  placement.Globe = this->Globe;
  placement.Exaggeration = exaggeration;
  if (this->Closed)
  {
    placement.PoleErrors = this->Closed->GetPoleErrors();
    const ElevationRanges::Range range = this->GetRange(*this->Lattice->GetRanges());
    const auto [low, high] = this->Lattice->AreErrorsKnown() ? range : Widen(range);
    placement.LowestHeight =
      low <= high ? std::min(low * placement.HeightScale, high * placement.HeightScale) : 0.0;
    placement.LowestHeight = this->Base
      ? std::min(placement.LowestHeight, *this->Base * placement.HeightScale)
      : placement.LowestHeight;
    placement.LowestHeight +=
      this->Globe->GetGeoid().HasGeoid() ? GeoidHeights::Lowest * std::abs(exaggeration) : 0.0;
  }
  return placement;
}

std::array<double, 6> AdaptiveTerrain::GetGlobeBounds(const TerrainPlacement& placement) const
{
  const std::array<double, 2> heights = this->GetSolidRange();
  std::array<double, 6> bounds = { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
  bool isFirst = true;
  for (const GeocentricFrame::Place& place : this->Globe->GetNodes())
  {
    for (int end = 0; end < 2 && heights[0] <= heights[1] && !std::isnan(place.Position[0]); ++end)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double world =
          place.Position[axis] + heights[end] * placement.HeightScale * place.Up[axis];
        double* range = &bounds[2 * axis];
        range[0] = isFirst ? world : std::min(range[0], world);
        range[1] = isFirst ? world : std::max(range[1], world);
      }
      isFirst = false;
    }
  }
  const double margin = this->Globe->GetNodeDistance() +
    (this->Globe->GetGeoid().HasGeoid() ? -GeoidHeights::Lowest * std::abs(placement.Exaggeration)
                                        : 0.0);
  for (int axis = 0; axis < 3 && !isFirst; ++axis)
  {
    bounds[2 * axis] -= margin;
    bounds[2 * axis + 1] += margin;
  }
  return bounds;
}

ElevationRanges::Range AdaptiveTerrain::GetRange(const ElevationRanges& ranges) const
{
  constexpr int coarsest = 64; // coarser than any level
  const RasterDescription& contents = this->Lattice->Describe();
  return ranges.Get(
    coarsest, { { 0.0, contents.Width - 1.0 } }, { { 0.0, contents.Height - 1.0 } });
}

// The heights of the terrain and of its base.
std::array<double, 2> AdaptiveTerrain::GetSolidRange() const
{
  const ElevationRanges::Range range = this->GetRange(*this->Lattice->GetRanges());
  std::array<double, 2> heights = { { range[0], range[1] } };
  if (this->Base && heights[0] <= heights[1])
  {
    heights[0] = std::min(heights[0], *this->Base);
  }
  return heights;
}

std::array<double, 3> AdaptiveTerrain::ToBase(
  const std::array<double, 3>& world, double exaggeration, double base) const
{
  const double height = base * this->Lattice->Describe().VerticalUnit * exaggeration;
  if (!this->Globe)
  {
    return { { world[0], world[1], height } };
  }
  const GeocentricFrame& frame = this->Globe->GetFrame();
  std::array<double, 3> place = frame.ToGeographic(world);
  place[2] = height + exaggeration * this->Globe->GetGeoid().Get(place[0], place[1]);
  return frame.ToWorld(place);
}

std::array<double, 6> AdaptiveTerrain::GetBounds(double exaggeration) const
{
  const RasterDescription& contents = this->Lattice->Describe();
  const TerrainPlacement placement = this->GetPlacement(exaggeration);
  if (this->Globe)
  {
    return this->GetGlobeBounds(placement);
  }
  const double columns = contents.Width - 1.0;
  const double rows = contents.Height - 1.0;
  const std::array<double, 2> heights = this->GetSolidRange();
  std::array<double, 6> bounds = { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
  for (int i = 0; i < 8 && heights[0] <= heights[1]; ++i)
  {
    const std::array<double, 3> corner =
      placement.ToWorld(i % 2 == 0 ? 0.0 : columns, i / 2 % 2 == 0 ? 0.0 : rows, heights[i / 4]);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = i == 0 ? corner[axis] : std::min(bounds[2 * axis], corner[axis]);
      bounds[2 * axis + 1] = i == 0 ? corner[axis] : std::max(bounds[2 * axis + 1], corner[axis]);
    }
  }
  return bounds;
}

std::int64_t AdaptiveTerrain::PlanMemory(std::int64_t limit)
{
  const int reads = static_cast<int>(
    std::clamp<std::int64_t>(limit / MemoryPerRead, 1, HeightTileCache::GetMaximumNumberOfReads()));
  this->Cache.SetNumberOfReads(reads);
  // Tiles get at least half, and more under low limits.
  const std::int64_t most = limit / 2 - std::min(limit / 8 * 3, std::int64_t(1) << 22);
  return limit - std::min(most, this->Lattice->GetMemorySize(reads));
}

void AdaptiveTerrain::SelectOnce(const TerrainView& view, double tolerance)
{
  // The background build of the index can replace them at any time.
  this->HasErrors = this->Lattice->AreErrorsKnown();
  const std::shared_ptr<const BlockErrors> errors = this->Lattice->GetErrors();
  const std::shared_ptr<const ElevationRanges> ranges = this->Lattice->GetRanges();
  const ElevationRanges wide(Widen(this->GetRange(*ranges)));
  const ElevationRanges& bounds = this->HasErrors ? *ranges : wide;
  TerrainBisection bisection(this->Dimensions[0], this->Dimensions[1], *errors, bounds,
    this->Globe ? this->Globe->GetPeriod() : 0);
  bisection.SetBase(this->Base);
  // Walls at holes depend on the faces on both sides.
  const std::optional<TerrainShare> share = this->Base ? std::nullopt : this->Share;
  bisection.SetShare(share);
  this->Cache.BeginFrame(GetSeconds());
  bisection.Select(view, tolerance * this->Coarsening, this->Cache);
  // Absurd heights can need any number of faces.
  double reduced = tolerance;
  for (double factor = FirstReduction; bisection.HasTooManyFaces() && std::isfinite(reduced);
       factor *= factor)
  {
    reduced *= factor;
    this->Cache.BeginFrame(GetSeconds());
    bisection.Select(view, reduced * this->Coarsening, this->Cache);
  }
  const auto select = [&](double coarsening)
  {
    this->Coarsening = coarsening;
    this->Cache.BeginFrame(GetSeconds()); // without the requests for the other tolerance
    bisection.Select(view, reduced * this->Coarsening, this->Cache);
    return bisection.GetFaces().size();
  };
  std::size_t faces = bisection.GetFaces().size();
  while (this->Coarsening > 1.0 && faces < this->MaximumNumberOfFaces / 2)
  {
    faces = select(std::max(1.0, this->Coarsening / CoarseningStep));
  }
  while (this->Globe && faces > this->MaximumNumberOfFaces && this->Coarsening < LargestCoarsening)
  {
    faces = select(this->Coarsening * CoarseningStep);
  }
  this->Faces = bisection.GetFaces();
  this->HiddenBlocks = bisection.GetHiddenBlocks();
  this->Error = bisection.GetError();
  this->FacesComplete = bisection.IsComplete() && this->HasErrors;
  this->Reduction = reduced / tolerance * this->Coarsening;
  this->Complete = this->FacesComplete && this->Reduction <= 1.0;
  const std::optional<TerrainShare> drawn =
    share ? std::optional<TerrainShare>(CoverFaces(*share, this->Faces)) : std::nullopt;
  this->ShadingTiles.clear();
  this->ShadingComplete = true;
  if (this->Shading)
  {
    MipmapTiles shading(this->Dimensions[0], this->Dimensions[1], bounds);
    shading.SetShare(drawn);
    shading.Select(view, ShadingShare * tolerance, this->Cache);
    this->ShadingTiles = shading.GetTiles();
    this->ShadingComplete = shading.IsComplete();
  }
  if (this->Imagery)
  {
    MipmapTiles imagery(this->Dimensions[0], this->Dimensions[1], bounds);
    imagery.SetShare(drawn);
    imagery.SelectImagery(view, *this->Imagery, this->Cache);
    this->ShadingTiles.insert(
      this->ShadingTiles.end(), imagery.GetTiles().begin(), imagery.GetTiles().end());
    this->Complete = this->Complete && imagery.IsComplete();
  }
  this->Cache.EndFrame();
  if (this->Globe)
  {
    this->Vertices.Update(*this->Globe, this->Faces);
  }
}

std::vector<TerrainShare> AdaptiveTerrain::Divide(
  const TerrainView& view, double tolerance, int number) const
{
  const bool areErrorsKnown = this->Lattice->AreErrorsKnown();
  const std::shared_ptr<const BlockErrors> errors = this->Lattice->GetErrors();
  const std::shared_ptr<const ElevationRanges> ranges = this->Lattice->GetRanges();
  const ElevationRanges wide(Widen(this->GetRange(*ranges)));
  return TerrainDivision(this->Dimensions, *errors, areErrorsKnown ? *ranges : wide)
    .Divide(view, tolerance, number);
}

// Tiles for shading that do not fit into memory do not matter.
bool AdaptiveTerrain::IsComplete() const
{
  return this->Complete &&
    (this->ShadingComplete || !(this->Cache.IsLoading() || this->Cache.NeedsFrame()));
}

bool AdaptiveTerrain::NeedsFrame() const
{
  const bool areErrorsComing =
    !this->HasErrors && (this->Lattice->AreErrorsKnown() || this->Lattice->AreErrorsPending());
  return areErrorsComing || this->Cache.IsLoading() || this->Cache.NeedsFrame();
}

void AdaptiveTerrain::Select(const TerrainView& view, double tolerance)
{
  this->Cache.SetFadeTime(FadeTime);
  this->SelectOnce(view, tolerance);
}

bool AdaptiveTerrain::SelectAndWait(
  const TerrainView& view, double tolerance, const std::function<bool()>& isAborted)
{
  this->Cache.SetFadeTime(0.0);
  do
  {
    this->SelectOnce(view, tolerance);
  } while (this->Cache.LoadWanted(isAborted));
  return !isAborted();
}
}
