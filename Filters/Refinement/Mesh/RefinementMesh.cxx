// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/RefinementMesh.h"

#include "Arrays/GhostCells.h"
#include "Mesh/GivenNormals.h"
#include "Mesh/NormalGroups.h"
#include "Mesh/PatchArrays.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Points/LocalPoints.h"
#include "Points/MergedPoints.h"
#include "Surfaces/FloatRange.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDisplacement.h"
#include "vtkLinearSurface.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

namespace relevo
{
namespace
{
bool isFinite(const float* v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

using Coordinates = std::array<double, 3>;

Coordinates load(const float* v)
{
  return { v[0], v[1], v[2] };
}

Coordinates subtract(const Coordinates& a, const Coordinates& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  Coordinates c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

double dot(const Coordinates& a, const Coordinates& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

double angle(const Coordinates& a, const Coordinates& b)
{
  const Coordinates c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

// Unit normals with a smaller difference are equal up to rounding.
constexpr float NormalRounding = 1e-5f;

// Sorts the numbers 0 to n - 1 by their keys (arrays of ints). The sort is stable. It starts with a
// counting sort by the first elements of the keys, which are below `limit` and rarely equal.
template <typename GetKey>
std::vector<int> sortByKey(size_t n, int limit, const GetKey& getKey)
{
  std::vector<int> starts(static_cast<size_t>(limit) + 1, 0);
  for (size_t i = 0; i < n; ++i)
  {
    ++starts[getKey(static_cast<int>(i))[0] + 1];
  }
  for (int k = 0; k < limit; ++k)
  {
    starts[k + 1] += starts[k];
  }
  std::vector<int> sorted(n);
  std::vector<int> next(starts.begin(), starts.end() - 1);
  for (size_t i = 0; i < n; ++i)
  {
    sorted[next[getKey(static_cast<int>(i))[0]]++] = static_cast<int>(i);
  }
  vtkSMPTools::For(0, limit,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        std::sort(sorted.begin() + starts[k], sorted.begin() + starts[k + 1],
          [&getKey](int l, int r)
          { return std::make_pair(getKey(l), l) < std::make_pair(getKey(r), r); });
      }
    });
  return sorted;
}
}

bool RefinementMesh::Build(vtkPolyData* input, vtkRefinementSurface* surface,
  vtkDisplacement* displacement, bool keepNormals, const GlobalSurfaceInfo* whole)
{
  *this = RefinementMesh();
  if (input->GetNumberOfCells() == 0)
  {
    return true;
  }
  if (!this->CheckCells(input))
  {
    return false;
  }
  this->NumberOfPoints = static_cast<int>(input->GetNumberOfPoints());
  this->MergedPoints = ComputeMergedPoints(input->GetPoints());
  this->BuildPoints(input, whole);
  this->BuildFaces(input);
  this->DropLoneFaces();

  if (!this->CheckRange(
        input, !displacement && (!surface || vtkLinearSurface::SafeDownCast(surface))))
  {
    return false;
  }
  if (displacement || (surface && surface->NeedsNormals()) ||
    (keepNormals && input->GetPointData()->GetNormals()))
  {
    this->BuildNormals(input);
    if (!this->MergedPoints.empty())
    {
      this->BuildDirections();
    }
  }
  if (!this->MergedPoints.empty() && !this->Faces.empty())
  {
    this->BuildMergedEdges();
  }
  if (displacement)
  {
    if (displacement->GetHeightMap() && !this->Faces.empty() &&
      !this->BuildTextureCoordinates(input))
    {
      return false;
    }
    this->BuildFrames(displacement->IsAlongNormal());
    if (!this->MergedPoints.empty())
    {
      this->BuildSeams();
    }
  }
  if (surface && !this->Faces.empty())
  {
    if (!this->BuildValues(input, surface) || !this->BuildTables(input, surface))
    {
      return false;
    }
    this->BuildVectors(surface);
    if (displacement && !surface->HasDirections() && this->Directions.empty() &&
      this->SplitsNormals(surface))
    {
      this->Directions = this->Normals;
    }
  }
  if (whole && whole->HasDirections && this->Directions.empty())
  {
    this->Directions = this->Normals;
  }
  this->RemoveGhosts(input);
  return true;
}

void RefinementMesh::RemoveGhosts(vtkPolyData* input)
{
  const GhostCells ghosts(input);
  if (!ghosts.AreAmong(0, input->GetNumberOfCells()))
  {
    return;
  }
  // Removes the numbers of removed faces. There are `each` per face.
  const auto keep = [&](auto& numbers, size_t each)
  {
    auto next = numbers.begin();
    for (size_t f = 0; f < this->Faces.size() && !numbers.empty(); ++f)
    {
      if (!ghosts.Has(this->Faces[f].Cell))
      {
        next = std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(f * each), each, next);
      }
    }
    numbers.erase(next, numbers.end());
  };
  keep(this->Vectors, 3 * static_cast<size_t>(this->VectorsPerFace));
  keep(this->Seams, 9);
  keep(this->TableEntries, 1);
  this->FaceMergedEdges.clear(); // no longer needed
  this->Faces.erase(std::remove_if(this->Faces.begin(), this->Faces.end(),
                      [&](const RefinementFace& face) { return ghosts.Has(face.Cell); }),
    this->Faces.end());
}

bool RefinementMesh::SplitsNormals(vtkRefinementSurface* surface) const
{
  for (int face = 0; face < static_cast<int>(this->Faces.size()); ++face)
  {
    if (surface->SplitsNormals(this->GetSurfaceFace(face)))
    {
      return true;
    }
  }
  return false;
}

bool RefinementMesh::BuildValues(vtkPolyData* input, vtkRefinementSurface* surface)
{
  const size_t perPoint = static_cast<size_t>(surface->GetNumberOfPointValues());
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  this->ValuesPerPoint = static_cast<int>(perPoint);
  this->Values.assign(perPoint * n, 0.0f);
  if (this->Values.empty())
  {
    return true;
  }
  if (!surface->GetPointValues(input, this->Values.data(), this->Error))
  {
    return false;
  }
  if (this->MergedPoints.empty())
  {
    return true;
  }
  // Each merged point gets one value: the mean over the distinct values of its points that faces
  // use.
  std::vector<char> isCorner(n, 0);
  std::vector<char> isShared(n, 0); // per merged point
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      isCorner[static_cast<size_t>(corner)] = 1;
    }
  }
  using Tuple = std::vector<float>;
  std::vector<std::pair<size_t, Tuple>> corners; // merged point and values
  for (size_t i = 0; i < n; ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    isShared[mergedPoint] |= mergedPoint != i ? 1 : 0;
  }
  for (size_t i = 0; i < n; ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    if (isCorner[i] && isShared[mergedPoint])
    {
      const auto first = this->Values.begin() + static_cast<std::ptrdiff_t>(perPoint * i);
      corners.emplace_back(mergedPoint, Tuple(first, first + this->ValuesPerPoint));
    }
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<double> sum(perPoint);
  std::map<size_t, Tuple> means;
  for (auto next = corners.begin(); next != corners.end();)
  {
    const size_t mergedPoint = next->first;
    int count = 0;
    std::fill(sum.begin(), sum.end(), 0.0);
    for (; next != corners.end() && next->first == mergedPoint; ++next, ++count)
    {
      std::transform(
        sum.begin(), sum.end(), next->second.begin(), sum.begin(), std::plus<double>());
    }
    Tuple& mean = means[mergedPoint];
    std::transform(sum.begin(), sum.end(), std::back_inserter(mean),
      [count](double value) { return static_cast<float>(value / count); });
  }
  for (size_t i = 0; i < n; ++i)
  {
    const auto mean = means.find(static_cast<size_t>(this->MergedPoints[i]));
    if (mean != means.end())
    {
      std::copy(mean->second.begin(), mean->second.end(),
        this->Values.begin() + static_cast<std::ptrdiff_t>(perPoint * i));
    }
  }
  return true;
}

bool RefinementMesh::BuildTables(vtkPolyData* input, vtkRefinementSurface* surface)
{
  if (!surface->HasTables())
  {
    return true;
  }
  if (!surface->BuildTables(input, this->Origin, this->Tables, this->Error))
  {
    return false;
  }
  this->TableEntries.reserve(this->Faces.size());
  for (const RefinementFace& face : this->Faces)
  {
    this->TableEntries.push_back(this->Tables.Entries[static_cast<size_t>(face.Cell)]);
  }
  this->Tables.Entries = {}; // no longer needed
  return true;
}

void RefinementMesh::BuildPoints(vtkPolyData* input, const GlobalSurfaceInfo* whole)
{
  LocalPoints points;
  points.Build(input->GetPoints(), whole ? &whole->PointBox : nullptr);
  std::copy_n(points.Origin, 3, this->Origin);
  this->Points = std::move(points.Coordinates);
}

bool RefinementMesh::CheckCells(vtkPolyData* input)
{
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  // Triangles are numbered in 29 bits: see PatternSelection::Instances.
  constexpr vtkIdType maximumTriangles = (vtkIdType(1) << 29) - 1;
  vtkIdType numberOfTriangles = 0;
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    numberOfTriangles += cells->GetNumberOfConnectivityIds();
  }
  if (numberOfPoints > std::numeric_limits<int>::max() ||
    input->GetNumberOfCells() > std::numeric_limits<int>::max() ||
    numberOfTriangles > 3 * maximumTriangles)
  {
    this->Error = "the mesh has too many points, cells or triangles: split it into blocks";
    return false;
  }
  vtkIdType cell = 0;
  for (vtkCellArray* cells :
    { input->GetVerts(), input->GetLines(), input->GetPolys(), input->GetStrips() })
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      iterator->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (ids[i] < 0 || ids[i] >= numberOfPoints)
        {
          this->Error = "cell " + std::to_string(cell) + " refers to point " +
            std::to_string(ids[i]) + ", but there are " + std::to_string(numberOfPoints) +
            " points";
          return false;
        }
      }
      ++cell;
    }
  }
  return true;
}

bool RefinementMesh::CheckRange(vtkPolyData* input, bool isFlat)
{
  const double most =
    isFlat ? static_cast<double>(std::numeric_limits<float>::max()) : LargestLength;
  const auto isWithin = [most](float x) { return std::abs(x) <= most; };
  if (std::all_of(this->Points.begin(), this->Points.end(), isWithin))
  {
    return true;
  }
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      iterator->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        double x[3];
        input->GetPoint(ids[i], x);
        const bool isFinite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
        if (isFinite &&
          !std::all_of(&this->Points[3 * ids[i]], &this->Points[3 * ids[i]] + 3, isWithin))
        {
          std::ostringstream text;
          text << "point " << ids[i] << " at (" << x[0] << ", " << x[1] << ", " << x[2]
               << ") is farther than " << most << " from the centre of the mesh, too far for floats"
               << (isFlat ? "" : " if faces are curved or displaced") << ": scale the mesh down";
          this->Error = text.str();
          return false;
        }
      }
    }
  }
  return true;
}

void RefinementMesh::BuildFaces(vtkPolyData* input)
{
  const bool isPatch = PatchArrays::AreOn(input);
  auto addTriangle = [&](vtkIdType a, vtkIdType b, vtkIdType c, int cell, const bool hidden[3])
  {
    const vtkIdType ids[3] = { a, b, c };
    int mergedPoints[3];
    for (int i = 0; i < 3; ++i)
    {
      mergedPoints[i] = this->GetMergedPoint(static_cast<int>(ids[i]));
    }
    const int pairs = (mergedPoints[0] == mergedPoints[1]) + (mergedPoints[1] == mergedPoints[2]) +
      (mergedPoints[0] == mergedPoints[2]);
    if (pairs > (isPatch ? 1 : 0) || !isFinite(&this->Points[3 * a]) ||
      !isFinite(&this->Points[3 * b]) || !isFinite(&this->Points[3 * c]))
    {
      ++this->NumberOfDroppedTriangles;
      return;
    }
    int order[3] = { 0, 1, 2 };
    std::sort(order, order + 3,
      [&mergedPoints](int l, int r) { return mergedPoints[l] < mergedPoints[r]; });
    RefinementFace face;
    face.Cell = cell;
    face.Order = static_cast<unsigned char>(GetCornerOrderCode(order[0], order[1], order[2]));
    face.HiddenEdges = 0;
    for (int i = 0; i < 3; ++i)
    {
      face.Corners[i] = static_cast<int>(ids[order[i]]);
      // The cell's edge i joins its corners i and i + 1: it is opposite to corner i + 2.
      const int lacking = 3 - order[EdgeCorners[i][0]] - order[EdgeCorners[i][1]];
      face.HiddenEdges |= hidden[(lacking + 1) % 3] ? 1 << i : 0;
    }
    this->Faces.push_back(face);
  };

  int cell =
    static_cast<int>(input->GetVerts()->GetNumberOfCells() + input->GetLines()->GetNumberOfCells());
  this->Faces.reserve(static_cast<size_t>(input->GetPolys()->GetNumberOfConnectivityIds() -
    2 *
      std::min(input->GetPolys()->GetNumberOfCells(),
        input->GetPolys()->GetNumberOfConnectivityIds() / 2)));
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell(), ++cell)
  {
    polys->GetCurrentCell(size, ids);
    this->NumberOfDroppedTriangles += size < 3 ? 1 : 0;
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      const bool hidden[3] = { i > 1, false, i + 2 < size };
      addTriangle(ids[0], ids[i], ids[i + 1], cell, hidden);
    }
  }
  auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    strips->GetCurrentCell(size, ids);
    this->NumberOfDroppedTriangles += size < 3 ? 1 : 0;
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const bool hidden[3] = { false, false, false };
      addTriangle(ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2], cell, hidden);
    }
  }
}

bool RefinementMesh::BuildTextureCoordinates(vtkPolyData* input)
{
  vtkDataArray* given = input->GetPointData()->GetTCoords();
  if (!given)
  {
    this->Error = "displacement by a height map needs texture coordinates (point data TCoords, 2 "
                  "components in [0, 1]), but the mesh has none";
    return false;
  }
  if (given->GetNumberOfComponents() < 2 || given->GetNumberOfTuples() < this->NumberOfPoints)
  {
    std::ostringstream text;
    text << "the texture coordinates \"" << (given->GetName() ? given->GetName() : "") << "\" have "
         << given->GetNumberOfComponents() << " components and " << given->GetNumberOfTuples()
         << " tuples, but displacement needs " << this->NumberOfPoints << " tuples of 2 components";
    this->Error = text.str();
    return false;
  }
  this->TextureCoordinates.resize(2 * static_cast<size_t>(this->NumberOfPoints));
  for (const RefinementFace& face : this->Faces)
  {
    for (int point : face.Corners)
    {
      for (int c = 0; c < 2; ++c)
      {
        const double value = given->GetComponent(point, c);
        if (!std::isfinite(value))
        {
          this->Error =
            "the texture coordinates of point " + std::to_string(point) + " are not finite";
          return false;
        }
        this->TextureCoordinates[2 * static_cast<size_t>(point) + c] = static_cast<float>(value);
      }
    }
  }
  return true;
}

vtkRefinementSurface::Face RefinementMesh::GetSurfaceFace(int face) const
{
  vtkRefinementSurface::Face result;
  result.Origin = this->Origin;
  for (int i = 0; i < 3; ++i)
  {
    const size_t id = 3 * static_cast<size_t>(this->Faces[face].Corners[i]);
    std::copy_n(&this->Points[id], 3, result.Points[i]);
    if (this->Normals.empty())
    {
      std::fill_n(result.Normals[i], 3, 0.0f);
    }
    else
    {
      std::copy_n(&this->Normals[id], 3, result.Normals[i]);
    }
  }
  const std::vector<float>& directions =
    this->Directions.empty() ? this->Normals : this->Directions;
  for (int i = 0; i < 3; ++i)
  {
    const int corner = this->Faces[face].Corners[i];
    result.Directions[i] =
      directions.empty() ? nullptr : &directions[3 * static_cast<size_t>(corner)];
    result.Values[i] = this->GetValues(corner);
  }
  result.MeshTables = &this->Tables;
  result.TableEntry =
    this->TableEntries.empty() ? -1 : this->TableEntries[static_cast<size_t>(face)];
  result.CornerOrder = this->Faces[face].Order;
  result.Vectors = this->Vectors.empty()
    ? nullptr
    : &this->Vectors[3 * static_cast<size_t>(this->VectorsPerFace) * face];
  return result;
}

void RefinementMesh::BuildNormals(vtkPolyData* input)
{
  this->Normals.assign(3 * static_cast<size_t>(this->NumberOfPoints), 0.0f);
  vtkDataArray* given = GetGivenNormals(input);
  bool missing = !given;
  for (vtkIdType i = 0; given && i < this->NumberOfPoints; ++i)
  {
    double normal[3];
    if (IsLengthOfNormal(GetUnitNormal(given, i, normal)))
    {
      std::copy_n(normal, 3, &this->Normals[3 * static_cast<size_t>(i)]);
    }
    else
    {
      missing = true;
    }
  }
  if (missing)
  {
    this->ComputeMissingNormals();
  }
}

// Replaces normals of zero by those of the adjacent faces, weighted by the angle at the point,
// which does not depend on the triangulation (Thuermer and Wuethrich 1998).
void RefinementMesh::ComputeMissingNormals()
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  std::vector<double> sums(3 * n, 0.0);
  std::vector<double> firsts(3 * n, 0.0); // for points where the faces cancel out
  for (const RefinementFace& face : this->Faces)
  {
    const auto& order = GetCornerOrder(face.Order);
    int corners[3];
    Coordinates p[3];
    for (int i = 0; i < 3; ++i)
    {
      corners[order[i]] = face.Corners[i];
      p[order[i]] = load(&this->Points[3 * static_cast<size_t>(face.Corners[i])]);
    }
    Coordinates normal = cross(subtract(p[1], p[0]), subtract(p[2], p[0]));
    vtkMath::Normalize(normal.data());
    for (int i = 0; i < 3; ++i)
    {
      const double weight = angle(subtract(p[(i + 1) % 3], p[i]), subtract(p[(i + 2) % 3], p[i]));
      const size_t mergedPoint = 3 * static_cast<size_t>(this->GetMergedPoint(corners[i]));
      const bool isFirst = std::all_of(
        &firsts[mergedPoint], &firsts[mergedPoint] + 3, [](double c) { return c == 0.0; });
      for (int c = 0; c < 3; ++c)
      {
        sums[mergedPoint + c] += weight * normal[c];
        firsts[mergedPoint + c] = isFirst ? normal[c] : firsts[mergedPoint + c];
      }
    }
  }
  for (size_t i = 0; i < n; ++i)
  {
    float* normal = &this->Normals[3 * i];
    if (std::all_of(normal, normal + 3, [](float c) { return c == 0.0f; }))
    {
      const size_t mergedPoint = 3 * static_cast<size_t>(this->GetMergedPoint(static_cast<int>(i)));
      Coordinates sum = { sums[mergedPoint], sums[mergedPoint + 1], sums[mergedPoint + 2] };
      constexpr double cancelled = 1e-9; // radians
      if (vtkMath::Normalize(sum.data()) < cancelled)
      {
        sum = { firsts[mergedPoint], firsts[mergedPoint + 1], firsts[mergedPoint + 2] };
      }
      std::copy_n(sum.data(), 3, normal);
    }
  }
}

// There is one direction per merged point. If its faces have different normals, it is the mean of
// the distinct ones, so that it does not depend on how points are shared.
// Normals that differ only by rounding, as on both sides of many texture seams, are made equal.
void RefinementMesh::BuildDirections()
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  std::vector<size_t> first(n, n); // a corner at each merged point
  std::vector<char> isCorner(n, 0);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      const size_t point = static_cast<size_t>(corner);
      size_t& lowest = first[static_cast<size_t>(this->MergedPoints[point])];
      lowest = std::min(lowest, point);
      isCorner[point] = 1;
    }
  }
  std::vector<char> isSplit(n, 0); // per merged point
  for (size_t i = 0; i < n; ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    const Coordinates difference = subtract(
      load(&this->Normals[3 * i]), load(&this->Normals[3 * std::min(first[mergedPoint], i)]));
    constexpr double squaredRounding = double(NormalRounding) * NormalRounding;
    isSplit[mergedPoint] |= isCorner[i] && dot(difference, difference) > squaredRounding ? 1 : 0;
  }
  std::vector<float> directions(3 * n, 0.0f);
  for (size_t i = 0; i < n; ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    if (isCorner[i] && !isSplit[mergedPoint])
    {
      std::copy_n(&this->Normals[3 * first[mergedPoint]], 3, &this->Normals[3 * i]);
    }
  }
  std::vector<std::pair<size_t, size_t>> corners; // merged point and point
  for (size_t i = 0; i < n; ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    if (isCorner[i] && isSplit[mergedPoint])
    {
      corners.emplace_back(mergedPoint, i);
    }
  }
  if (corners.empty())
  {
    return;
  }
  std::sort(corners.begin(), corners.end());
  std::vector<vec3> normals;
  std::vector<vtkIdType> groups;
  for (auto next = corners.begin(); next != corners.end();)
  {
    const size_t mergedPoint = next->first;
    normals.clear();
    for (; next != corners.end() && next->first == mergedPoint; ++next)
    {
      const float* normal = &this->Normals[3 * next->second];
      normals.push_back(vec3(normal[0], normal[1], normal[2]));
    }
    GroupNormals(normals, NormalRounding, groups);
    for (size_t i = 0; i < groups.size(); ++i)
    {
      for (int c = 0; groups[i] == static_cast<vtkIdType>(i) && c < 3; ++c)
      {
        directions[3 * mergedPoint + c] += normals[i][c];
      }
    }
  }
  for (size_t i = 0; i < n; ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    float* direction = &directions[3 * i];
    if (mergedPoint != i)
    {
      std::copy_n(&directions[3 * mergedPoint], 3, direction);
    }
    else if (!isSplit[mergedPoint] || vtkMath::Normalize(direction) == 0.0f)
    {
      std::copy_n(&this->Normals[3 * std::min(first[mergedPoint], i)], 3, direction);
    }
  }
  this->Directions.swap(directions);
}

// Gradients of texture coordinates must not depend on how points are shared. Coincident points are
// therefore merged, except at seams of texture coordinates and creases of normals.
std::vector<size_t> RefinementMesh::FindFramePoints() const
{
  std::vector<size_t> framePoints(static_cast<size_t>(this->NumberOfPoints));
  std::iota(framePoints.begin(), framePoints.end(), 0);
  if (this->MergedPoints.empty())
  {
    return framePoints;
  }
  std::vector<char> isShared(framePoints.size(), 0); // per merged point
  for (size_t i = 0; i < framePoints.size(); ++i)
  {
    const size_t mergedPoint = static_cast<size_t>(this->MergedPoints[i]);
    isShared[mergedPoint] |= mergedPoint != i ? 1 : 0;
  }
  using Key = std::tuple<vtkIdType, float, float>;
  std::vector<std::pair<Key, size_t>> points;
  for (size_t i = 0; i < framePoints.size(); ++i)
  {
    const vtkIdType mergedPoint = this->MergedPoints[i];
    if (isShared[static_cast<size_t>(mergedPoint)])
    {
      const float* uv =
        this->TextureCoordinates.empty() ? nullptr : &this->TextureCoordinates[2 * i];
      points.push_back({ Key(mergedPoint, uv ? uv[0] : 0.0f, uv ? uv[1] : 0.0f), i });
    }
  }
  std::sort(points.begin(), points.end());
  std::vector<vec3> normals;
  std::vector<vtkIdType> groups;
  for (auto first = points.begin(), last = first; first != points.end(); first = last)
  {
    normals.clear();
    for (; last != points.end() && last->first == first->first; ++last)
    {
      const float* normal = &this->Normals[3 * last->second];
      normals.push_back(vec3(normal[0], normal[1], normal[2]));
    }
    GroupNormals(normals, NormalRounding, groups);
    for (size_t i = 0; i < groups.size(); ++i)
    {
      framePoints[(first + static_cast<std::ptrdiff_t>(i))->second] =
        (first + static_cast<std::ptrdiff_t>(groups[i]))->second;
    }
  }
  return framePoints;
}

void RefinementMesh::BuildFrames(bool alongNormal)
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  const std::vector<float>& directions =
    this->Directions.empty() ? this->Normals : this->Directions;
  const std::vector<size_t> framePoints = this->FindFramePoints();
  std::vector<double> sums(8 * n, 0.0); // gradients, mean curvature, area
  for (const RefinementFace& face : this->Faces)
  {
    Coordinates p[3];
    for (int i = 0; i < 3; ++i)
    {
      p[i] = load(&this->Points[3 * static_cast<size_t>(face.Corners[i])]);
    }
    const Coordinates normal = cross(subtract(p[1], p[0]), subtract(p[2], p[0]));
    const double squared = dot(normal, normal);
    if (!(squared > 0.0))
    {
      continue;
    }
    double values[7] = { 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      const size_t point = static_cast<size_t>(face.Corners[i]);
      // This is the gradient of a corner's barycentric weight.
      const Coordinates gradient = cross(normal, subtract(p[(i + 2) % 3], p[(i + 1) % 3]));
      for (int c = 0; c < 3; ++c)
      {
        const double g = gradient[c] / squared;
        if (!this->TextureCoordinates.empty())
        {
          values[c] += g * this->TextureCoordinates[2 * point];
          values[3 + c] += g * this->TextureCoordinates[2 * point + 1];
        }
        if (alongNormal)
        {
          // Half the divergence of the unit normals is the mean curvature.
          values[6] += 0.5 * g * directions[3 * point + c];
        }
      }
    }
    const double area = std::sqrt(squared);
    for (int corner : face.Corners)
    {
      double* sum = &sums[8 * framePoints[static_cast<size_t>(corner)]];
      for (int k = 0; k < 7; ++k)
      {
        sum[k] += area * values[k];
      }
      sum[7] += area;
    }
  }
  this->Frames.assign(8 * n, 0.0f);
  for (size_t i = 0; i < n; ++i)
  {
    const double* sum = &sums[8 * framePoints[i]];
    if (sum[7] > 0.0)
    {
      float* frame = &this->Frames[8 * i];
      for (int c = 0; c < 3; ++c)
      {
        frame[c] = static_cast<float>(sum[c] / sum[7]);
        frame[4 + c] = static_cast<float>(sum[3 + c] / sum[7]);
      }
      frame[3] = static_cast<float>(sum[6] / sum[7]);
    }
  }
}

void RefinementMesh::DropLoneFaces()
{
  const auto getMergedPoints = [this](const RefinementFace& face) -> std::array<int, 3>
  {
    return { this->GetMergedPoint(face.Corners[0]), this->GetMergedPoint(face.Corners[1]),
      this->GetMergedPoint(face.Corners[2]) };
  };
  // Corners are sorted, so coincident corners are adjacent.
  const auto isCollapsed = [&](const RefinementFace& face)
  {
    const std::array<int, 3> mergedPoints = getMergedPoints(face);
    return mergedPoints[0] == mergedPoints[1] || mergedPoints[1] == mergedPoints[2];
  };
  if (std::none_of(this->Faces.begin(), this->Faces.end(), isCollapsed))
  {
    return;
  }
  std::set<std::pair<int, int>> sides;
  for (const RefinementFace& face : this->Faces)
  {
    const std::array<int, 3> mergedPoints = getMergedPoints(face);
    for (int e = 0; !isCollapsed(face) && e < 3; ++e)
    {
      sides.emplace(mergedPoints[EdgeCorners[e][0]], mergedPoints[EdgeCorners[e][1]]);
    }
  }
  const auto isLone = [&](const RefinementFace& face)
  {
    const std::array<int, 3> mergedPoints = getMergedPoints(face);
    return isCollapsed(face) && sides.count({ mergedPoints[0], mergedPoints[2] }) == 0;
  };
  const auto kept = std::remove_if(this->Faces.begin(), this->Faces.end(), isLone);
  this->NumberOfDroppedTriangles += this->Faces.end() - kept;
  this->Faces.erase(kept, this->Faces.end());
}

void RefinementMesh::BuildMergedEdges()
{
  using Key = std::array<int, 4>; // merged points, points
  const auto getKey = [this](int faceEdge)
  {
    const int* corners = this->Faces[faceEdge / 3].Corners;
    const int a = corners[EdgeCorners[faceEdge % 3][0]];
    const int b = corners[EdgeCorners[faceEdge % 3][1]];
    return Key{ { this->GetMergedPoint(a), this->GetMergedPoint(b), a, b } };
  };
  const std::vector<int> sorted = sortByKey(3 * this->Faces.size(), this->NumberOfPoints, getKey);
  this->FaceMergedEdges.resize(sorted.size());
  this->MergedEdgeOffsets.clear();
  this->MergedEdgePairs.clear();
  Key previous{ { -1, -1, -1, -1 } };
  for (int faceEdge : sorted)
  {
    const Key key = getKey(faceEdge);
    if (key[0] != previous[0] || key[1] != previous[1])
    {
      this->MergedEdgeOffsets.push_back(static_cast<int>(this->MergedEdgePairs.size()));
    }
    if (key != previous)
    {
      this->MergedEdgePairs.push_back({ { key[2], key[3] } });
    }
    this->FaceMergedEdges[faceEdge] = static_cast<int>(this->MergedEdgeOffsets.size()) - 1;
    previous = key;
  }
  this->MergedEdgeOffsets.push_back(static_cast<int>(this->MergedEdgePairs.size()));
}

void RefinementMesh::BuildSeams()
{
  // Find the lowest point of each merged point that a face uses.
  std::vector<int> first(static_cast<size_t>(this->NumberOfPoints), this->NumberOfPoints);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      int& lowest = first[static_cast<size_t>(this->GetMergedPoint(corner))];
      lowest = std::min(lowest, corner);
    }
  }
  // The pair of an edge must not depend on how points are shared.
  const std::vector<size_t> framePoints = this->FindFramePoints();
  const auto getFramePoints = [&framePoints](const std::array<int, 2>& pair)
  {
    return std::make_pair(
      framePoints[static_cast<size_t>(pair[0])], framePoints[static_cast<size_t>(pair[1])]);
  };
  this->Seams.resize(9 * this->Faces.size());
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int edge = this->FaceMergedEdges[3 * f + i];
      const auto pairs = this->MergedEdgePairs.begin();
      const auto& pair = *std::min_element(pairs + this->MergedEdgeOffsets[edge],
        pairs + this->MergedEdgeOffsets[edge + 1],
        [&](const auto& a, const auto& b) { return getFramePoints(a) < getFramePoints(b); });
      this->Seams[9 * f + i] =
        first[static_cast<size_t>(this->GetMergedPoint(this->Faces[f].Corners[i]))];
      this->Seams[9 * f + 3 + i] = pair[0];
      this->Seams[9 * f + 6 + i] = pair[1];
    }
  }
}

void RefinementMesh::BuildVectors(vtkRefinementSurface* surface)
{
  const int positions = surface->GetNumberOfEdgePositions();
  this->VectorsPerEdge = positions + surface->GetNumberOfEdgeNormals();
  this->VectorsPerFace = 3 * this->VectorsPerEdge + surface->GetNumberOfFacePositions() +
    surface->GetNumberOfFaceNormals();
  this->Vectors.assign(3 * static_cast<size_t>(this->VectorsPerFace) * this->Faces.size(), 0.0f);
  if (this->Vectors.empty())
  {
    return;
  }
  auto getCorner = [this](int point)
  {
    const size_t id = static_cast<size_t>(point);
    return vtkRefinementSurface::Corner{ &this->Points[3 * id],
      this->Normals.empty() ? nullptr : &this->Normals[3 * id], this->GetValues(point) };
  };
  auto computeEdge = [&](int a, int b, float* vectors)
  { surface->ComputeEdgeVectors(getCorner(a), getCorner(b), vectors); };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> other(3 * static_cast<size_t>(this->VectorsPerEdge));
      for (vtkIdType f = begin; f < end; ++f)
      {
        const RefinementFace& face = this->Faces[f];
        float* vectors = &this->Vectors[3 * static_cast<size_t>(this->VectorsPerFace) * f];
        float* edgeNormals[3];
        for (int i = 0; i < 3; ++i)
        {
          float* edge = vectors + 3 * i * this->VectorsPerEdge;
          edgeNormals[i] = edge + 3 * positions;
          computeEdge(face.Corners[EdgeCorners[i][0]], face.Corners[EdgeCorners[i][1]], edge);
          if (this->FaceMergedEdges.empty())
          {
            continue;
          }
          const int id = this->FaceMergedEdges[3 * f + i];
          const int pairs = this->MergedEdgeOffsets[id + 1] - this->MergedEdgeOffsets[id];
          if (pairs > 1)
          {
            // The mean over all sides is summed in the same order by each of them.
            std::fill_n(edge, 3 * positions, 0.0f);
            for (int k = 0; k < pairs; ++k)
            {
              const auto& pair = this->MergedEdgePairs[this->MergedEdgeOffsets[id] + k];
              computeEdge(pair[0], pair[1], other.data());
              for (int c = 0; c < 3 * positions; ++c)
              {
                edge[c] += other[c] / static_cast<float>(pairs);
              }
            }
          }
        }
        surface->ComputeFaceVectors(this->GetSurfaceFace(static_cast<int>(f)),
          vectors + 9 * this->VectorsPerEdge, edgeNormals);
      }
    });
}

void RefinementMesh::BuildEdges()
{
  using Key = std::array<int, 2>;
  const auto getKey = [this](int faceEdge)
  {
    const int* corners = this->Faces[faceEdge / 3].Corners;
    const int a = corners[EdgeCorners[faceEdge % 3][0]];
    const int b = corners[EdgeCorners[faceEdge % 3][1]];
    return Key{ { std::min(a, b), std::max(a, b) } };
  };
  const std::vector<int> sorted = sortByKey(3 * this->Faces.size(), this->NumberOfPoints, getKey);
  this->FaceEdges.resize(sorted.size());
  this->EdgeOwners.clear();
  Key previous{ { -1, -1 } };
  for (int faceEdge : sorted)
  {
    const Key key = getKey(faceEdge);
    if (key != previous)
    {
      this->EdgeOwners.push_back(faceEdge);
      previous = key;
    }
    this->FaceEdges[faceEdge] = static_cast<int>(this->EdgeOwners.size()) - 1;
  }
}
}
