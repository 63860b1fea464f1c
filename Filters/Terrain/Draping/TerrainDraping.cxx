// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping/TerrainDraping.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace relevo
{
namespace
{
// Smaller parts are left out because of rounding errors.
constexpr double SmallestPart = 1e-6;

bool IsOnMap(const MapPosition& position)
{
  return std::isfinite(position[0]) && std::isfinite(position[1]);
}

// The part of a convex polygon in which a linear function is not negative.
template <typename Function>
void ClipPolygon(std::vector<MapPosition>& polygon, const Function& function)
{
  const bool isInside = std::all_of(polygon.begin(), polygon.end(),
    [&](const MapPosition& position) { return function(position) >= 0.0; });
  if (isInside)
  {
    return;
  }
  std::vector<MapPosition> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const MapPosition& here = polygon[i];
    const MapPosition& next = polygon[(i + 1) % polygon.size()];
    const double a = function(here);
    const double b = function(next);
    if (a >= 0.0)
    {
      inside.push_back(here);
    }
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0))
    {
      inside.push_back(MapSegment{ here, next }.Get(a / (a - b)));
    }
  }
  polygon.swap(inside);
}

double GetArea(const std::vector<MapPosition>& polygon)
{
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    twice += GetTwiceArea(polygon[0], polygon[i - 1], polygon[i]);
  }
  return 0.5 * std::abs(twice);
}

template <typename Function>
void ForCells(vtkCellArray* cells, vtkIdType& cell, const Function& function)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    const vtkIdType* points = nullptr;
    vtkIdType count = 0;
    iterator->GetCurrentCell(count, points);
    function(std::vector<vtkIdType>(points, points + count), cell);
    ++cell;
  }
}
}

// A draped line that is not complete.
struct TerrainDraping::Line
{
  vtkIdType Cell;
  Ids Points;
  double Length = 0.0; // of all parts, in samples
};

// The parts of a draped polygon.
struct TerrainDraping::Fragments
{
  vtkIdType Cell;
  // Points of the output by their positions. Equal positions of neighbours differ by rounding.
  using Key = std::pair<std::int64_t, std::int64_t>;
  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      constexpr std::uint64_t factor = 0x9e3779b97f4a7c15u; // of Fibonacci hashing
      const std::uint64_t mixed = static_cast<std::uint64_t>(key.first) * factor;
      return static_cast<std::size_t>(
        (mixed ^ mixed >> 32 ^ static_cast<std::uint64_t>(key.second)) * factor >> 16);
    }
  };
  std::unordered_map<Key, vtkIdType, Hash> Points;
  double Area = 0.0; // in squares of samples
};

TerrainDraping::TerrainDraping(DrapedSurface& surface, const Settings& settings, vtkPolyData* input,
  std::vector<MapPosition> positions)
  : Surface(surface)
  , Current(settings)
  , Input(input)
  , Positions(std::move(positions))
  , Output(input, settings.Offset)
{
}

TerrainDraping::Result TerrainDraping::Run(vtkPolyData* output)
{
  vtkIdType cell = 0;
  const auto drape = [&](vtkCellArray* cells, auto function)
  {
    ForCells(cells, cell,
      [&](const Ids& ids, vtkIdType id)
      {
        if (!this->IsToStop())
        {
          (this->*function)(ids, id);
        }
      });
  };
  drape(this->Input->GetVerts(), &TerrainDraping::DrapePoints);
  drape(this->Input->GetLines(), &TerrainDraping::DrapeLine);
  drape(this->Input->GetPolys(), &TerrainDraping::DrapePolygon);
  drape(this->Input->GetStrips(), &TerrainDraping::DrapeStrip);
  this->Output.Finish(output);
  return this->State;
}

bool TerrainDraping::IsToStop()
{
  if (this->State == Result::Done)
  {
    this->State = this->Current.IsAborted()                          ? Result::Aborted
      : this->Output.GetNumberOfCells() > this->Current.MaximumCells ? Result::TooManyCells
                                                                     : Result::Done;
  }
  return this->State != Result::Done;
}

//------------------------------------------------------------------------------
// Maps around the earth

MapPosition TerrainDraping::Shift(const MapPosition& position, int periods) const
{
  return { { position[0] + periods * this->Current.Period[0],
    position[1] + periods * this->Current.Period[1] } };
}

TerrainDraping::Place TerrainDraping::Move(const Place& place, int periods) const
{
  return { place.Id, place.Shift + periods, this->Shift(place.Position, periods) };
}

// Points that do not exist, or are far beyond the raster, are not on the map.
MapPosition TerrainDraping::GetPosition(vtkIdType id) const
{
  constexpr double farthest = 1e9;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const bool exists = id >= 0 && static_cast<std::size_t>(id) < this->Positions.size();
  const MapPosition position =
    exists ? this->Positions[static_cast<std::size_t>(id)] : MapPosition{ { none, none } };
  const bool isNear = std::abs(position[0]) <= farthest && std::abs(position[1]) <= farthest;
  return isNear ? position : MapPosition{ { none, none } };
}

// Each point is moved to the copy next to the one before it.
TerrainDraping::Places TerrainDraping::Unroll(const Ids& ids) const
{
  const MapPosition& period = this->Current.Period;
  const double squared = period[0] * period[0] + period[1] * period[1];
  Places places;
  places.reserve(ids.size());
  const Place* last = nullptr;
  for (vtkIdType id : ids)
  {
    Place place = { id, 0, this->GetPosition(id) };
    if (squared > 0.0 && last && IsOnMap(place.Position))
    {
      const double along = ((last->Position[0] - place.Position[0]) * period[0] +
                             (last->Position[1] - place.Position[1]) * period[1]) /
        squared;
      place = this->Move(place, static_cast<int>(std::round(along)));
    }
    places.push_back(place);
    last = IsOnMap(place.Position) ? &places.back() : nullptr;
  }
  return places;
}

// The first and the last copy that can lie on the raster.
std::pair<int, int> TerrainDraping::FindCopies(const Places& places) const
{
  const MapPosition& period = this->Current.Period;
  const double squared = period[0] * period[0] + period[1] * period[1];
  if (squared == 0.0)
  {
    return { 0, 0 };
  }
  const auto project = [&](const MapPosition& position)
  { return (position[0] * period[0] + position[1] * period[1]) / squared; };
  MapBox of;
  for (const Place& place : places)
  {
    if (IsOnMap(place.Position))
    {
      of.Add({ { project(place.Position), 0.0 } });
    }
  }
  const MapBox box = this->Surface.GetBox();
  MapBox raster;
  for (int corner = 0; corner < 4; ++corner)
  {
    raster.Add({ { project({ { corner % 2 == 0 ? box.Low[0] : box.High[0],
                     corner / 2 == 0 ? box.Low[1] : box.High[1] } }),
      0.0 } });
  }
  if (of.Low[0] > of.High[0])
  {
    return { 0, 0 };
  }
  return { static_cast<int>(std::ceil(raster.Low[0] - of.High[0] - SmallestPart)),
    static_cast<int>(std::floor(raster.High[0] - of.Low[0] + SmallestPart)) };
}

//------------------------------------------------------------------------------
// Points and lines

bool TerrainDraping::FindPoint(const MapPosition& position, SurfacePoint& point)
{
  MapBox box;
  box.Add({ { position[0] - MapSegment::Tolerance, position[1] - MapSegment::Tolerance } });
  box.Add({ { position[0] + MapSegment::Tolerance, position[1] + MapSegment::Tolerance } });
  bool isFound = false;
  this->Surface.Visit(box, nullptr,
    [&](const TerrainPatch& patch)
    {
      isFound = patch.FindPoint(position, point);
      return !isFound;
    });
  return isFound;
}

// Cells that share a point of the input share it in the output.
vtkIdType TerrainDraping::AddVertex(const Place& place, const SurfacePoint& point)
{
  const auto [found, isNew] = this->Vertices.emplace(std::make_pair(place.Id, place.Shift), 0);
  if (isNew)
  {
    found->second =
      this->Output.AddPoint(point, { { { place.Id, 0, 0 } }, { { 1.0, 0.0, 0.0 } }, 1 });
  }
  return found->second;
}

void TerrainDraping::DrapePoints(const Ids& ids, vtkIdType cell)
{
  Ids points;
  for (vtkIdType id : ids)
  {
    const Places places = this->Unroll({ id });
    const auto [first, last] = this->FindCopies(places);
    bool isFound = false;
    for (int copy = first; copy <= last && IsOnMap(places[0].Position) && !isFound; ++copy)
    {
      const Place place = this->Move(places[0], copy);
      SurfacePoint point;
      isFound = this->FindPoint(place.Position, point);
      if (isFound)
      {
        points.push_back(this->AddVertex(place, point));
      }
    }
    this->LeftOut = this->LeftOut || !isFound;
  }
  if (!points.empty())
  {
    this->Output.AddCell(DrapedOutput::VERTICES, points, cell);
  }
}

void TerrainDraping::DrapeLine(const Ids& ids, vtkIdType cell)
{
  const Places places = this->Unroll(ids);
  const auto [firstCopy, lastCopy] = this->FindCopies(places);
  Line line;
  line.Cell = cell;
  double length = 0.0;
  for (int copy = firstCopy; copy <= std::max(firstCopy, lastCopy); ++copy)
  {
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      const Place start = this->Move(places[i - 1], copy);
      const Place end = this->Move(places[i], copy);
      if (!IsOnMap(start.Position) || !IsOnMap(end.Position))
      {
        this->LeftOut = true;
        this->EndLine(line);
        continue;
      }
      length += copy == firstCopy ? MapSegment{ start.Position, end.Position }.GetLength() : 0.0;
      this->AddSegment(line, start, end);
    }
    this->EndLine(line);
  }
  this->LeftOut = this->LeftOut || line.Length < length - SmallestPart * std::max(1.0, length);
}

void TerrainDraping::AddSegment(Line& line, const Place& start, const Place& end)
{
  const MapSegment segment = { start.Position, end.Position };
  const double length = segment.GetLength();
  if (length <= MapSegment::Tolerance)
  {
    SurfacePoint point;
    if (!line.Points.empty() && this->FindPoint(end.Position, point))
    {
      line.Points.push_back(this->AddVertex(end, point));
    }
    return;
  }
  MapBox box;
  box.Add(start.Position);
  box.Add(end.Position);
  this->Pieces.clear();
  this->Surface.Visit(box, &segment,
    [&](const TerrainPatch& patch)
    {
      patch.AddPieces(segment, this->Pieces);
      return !this->IsToStop();
    });
  std::sort(this->Pieces.begin(), this->Pieces.end(),
    [](const auto& a, const auto& b) { return a.First < b.First; });
  const double rounding = 4.0 * MapSegment::Tolerance / length;
  const auto addPoint = [&](double t, const SurfacePoint& point)
  {
    if (t <= rounding || t >= 1.0 - rounding)
    {
      return this->AddVertex(t <= rounding ? start : end, point);
    }
    return this->Output.AddPoint(
      point, { { { start.Id, end.Id, 0 } }, { { 1.0 - t, t, 0.0 } }, 2 });
  };
  double covered = 0.0;
  for (const TerrainPatch::Piece& piece : this->Pieces)
  {
    // Pieces along an edge are those of both patches.
    if (piece.Last <= covered + rounding)
    {
      continue;
    }
    if (piece.First > covered + rounding)
    {
      this->EndLine(line);
    }
    // Patches of different levels meet in steps out of sight.
    const bool isStep =
      !line.Points.empty() && this->Output.IsStep(line.Points.back(), piece.FirstPoint);
    if (line.Points.empty() || isStep)
    {
      line.Points.push_back(addPoint(piece.First, piece.FirstPoint));
    }
    line.Points.push_back(addPoint(piece.Last, piece.LastPoint));
    line.Length += (piece.Last - std::max(covered, piece.First)) * length;
    covered = piece.Last;
  }
  if (covered < 1.0 - rounding)
  {
    this->EndLine(line);
  }
}

void TerrainDraping::EndLine(Line& line)
{
  if (line.Points.size() > 1)
  {
    this->Output.AddCell(DrapedOutput::LINES, line.Points, line.Cell);
  }
  line.Points.clear();
}

//------------------------------------------------------------------------------
// Polygons

void TerrainDraping::DrapePolygon(const Ids& ids, vtkIdType cell)
{
  const Places places = this->Unroll(ids);
  if (!std::all_of(
        places.begin(), places.end(), [](const Place& place) { return IsOnMap(place.Position); }))
  {
    this->LeftOut = true;
    return;
  }
  vtkNew<vtkPolygon> polygon;
  const auto count = static_cast<vtkIdType>(places.size());
  polygon->GetPoints()->SetDataTypeToDouble();
  polygon->GetPoints()->SetNumberOfPoints(count);
  polygon->GetPointIds()->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const MapPosition& position = places[static_cast<std::size_t>(i)].Position;
    polygon->GetPoints()->SetPoint(i, position[0], position[1], 0.0);
    polygon->GetPointIds()->SetId(i, i);
  }
  vtkNew<vtkIdList> triangles;
  vtkNew<vtkPoints> points;
  if (count < 3 || !polygon->Triangulate(0, triangles, points))
  {
    return; // no area
  }
  const auto [firstCopy, lastCopy] = this->FindCopies(places);
  Fragments fragments;
  fragments.Cell = cell;
  double area = 0.0;
  for (vtkIdType i = 0; i + 2 < triangles->GetNumberOfIds(); i += 3)
  {
    std::array<Place, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = places[static_cast<std::size_t>(triangles->GetId(i + k))];
    }
    area += GetArea({ corners[0].Position, corners[1].Position, corners[2].Position });
    for (int copy = firstCopy; copy <= lastCopy; ++copy)
    {
      this->DrapeTriangle({ { this->Move(corners[0], copy), this->Move(corners[1], copy),
                            this->Move(corners[2], copy) } },
        fragments);
    }
  }
  this->LeftOut = this->LeftOut || fragments.Area < (1.0 - SmallestPart) * area;
}

void TerrainDraping::DrapeStrip(const Ids& ids, vtkIdType cell)
{
  for (std::size_t i = 2; i < ids.size(); ++i)
  {
    this->DrapePolygon({ ids[i - 2], ids[i - 1], ids[i] }, cell);
  }
}

void TerrainDraping::DrapeTriangle(const std::array<Place, 3>& corners, Fragments& fragments)
{
  const double area = GetTwiceArea(corners[0].Position, corners[1].Position, corners[2].Position);
  if (area == 0.0)
  {
    return;
  }
  if (area < 0.0)
  {
    this->DrapeTriangle({ { corners[0], corners[2], corners[1] } }, fragments);
    return;
  }
  MapBox box;
  for (const Place& corner : corners)
  {
    box.Add(corner.Position);
  }
  this->Surface.Visit(box, nullptr,
    [&](const TerrainPatch& patch)
    {
      patch.VisitTriangles(box,
        [&](const SurfaceTriangle& triangle)
        {
          this->AddFragment(triangle, patch.GetBox(), corners, fragments);
          return this->Output.GetNumberOfCells() <= this->Current.MaximumCells;
        });
      return !this->IsToStop();
    });
}

// Adds the intersection of a triangle of the surface with one of the input.
void TerrainDraping::AddFragment(const SurfaceTriangle& triangle, const MapBox& box,
  const std::array<Place, 3>& corners, Fragments& fragments)
{
  std::vector<MapPosition>& polygon = this->Polygon;
  polygon.clear();
  for (const SurfaceVertex& vertex : triangle)
  {
    polygon.push_back(vertex.Position);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    ClipPolygon(polygon, [&](const MapPosition& p) { return p[axis] - box.Low[axis]; });
    ClipPolygon(polygon, [&](const MapPosition& p) { return box.High[axis] - p[axis]; });
  }
  const std::array<MapPosition, 3> whole = { { corners[0].Position, corners[1].Position,
    corners[2].Position } };
  for (int i = 0; i < 3; ++i)
  {
    ClipPolygon(
      polygon, [&](const MapPosition& p) { return GetTwiceArea(whole[i], whole[(i + 1) % 3], p); });
  }
  // All polygons are counter-clockwise seen from above.
  const double turn =
    GetTwiceArea(triangle[0].Position, triangle[1].Position, triangle[2].Position);
  if ((turn < 0.0) != this->Current.IsMirrored)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  const double area = GetArea(polygon);
  Ids& points = this->PolygonPoints;
  points.clear();
  for (const MapPosition& position : polygon)
  {
    const auto round = [](double x)
    { return static_cast<std::int64_t>(std::round(x * 1048576.0)); };
    const auto [found, isNew] =
      fragments.Points.emplace(std::make_pair(round(position[0]), round(position[1])), 0);
    if (isNew)
    {
      found->second = this->Output.AddPoint(GetSurfacePoint(triangle, position),
        { { { corners[0].Id, corners[1].Id, corners[2].Id } }, GetTriangleWeights(whole, position),
          3 });
    }
    if (points.empty() || (points.back() != found->second && points.front() != found->second))
    {
      points.push_back(found->second);
    }
  }
  if (points.size() > 2)
  {
    this->Output.AddCell(DrapedOutput::POLYGONS, points, fragments.Cell);
    fragments.Area += area;
  }
}
}
