// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/RefinementMesh.h"

#include "Arrays/GhostCells.h"
#include "Surfaces/FloatRange.h"

#include "Mesh/FaceBounds.h"
#include "Mesh/PatchArrays.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Points/LocalPoints.h"
#include "Points/MergedPoints.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDisplacement.h"
#include "vtkLinearSurface.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace relevo
{
namespace
{
bool isFinite(const float* v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
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
  this->Places = ComputePlaces(input->GetPoints());
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
    if (!this->Places.empty())
    {
      this->BuildDirections();
    }
  }
  if (!this->Places.empty() && !this->Faces.empty())
  {
    this->BuildPlaceEdges();
  }
  if (displacement)
  {
    if (displacement->GetHeightMap() && !this->Faces.empty() &&
      !this->BuildTextureCoordinates(input))
    {
      return false;
    }
    this->BuildFrames(displacement->IsAlongNormal());
    if (!this->Places.empty())
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
  // Keeps the numbers that belong to the faces that stay: `each` per face.
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
  this->FacePlaceEdges.clear(); // has done its work
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
  if (this->Places.empty())
  {
    return true;
  }
  // One value per place: the mean over the points that faces use.
  std::vector<char> isCorner(n, 0);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      isCorner[static_cast<size_t>(corner)] = 1;
    }
  }
  std::vector<double> sums(perPoint * n, 0.0);
  std::vector<int> counts(n, 0);
  for (size_t i = 0; i < n; ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[i]);
    counts[place] += isCorner[i];
    for (size_t k = 0; isCorner[i] && k < perPoint; ++k)
    {
      sums[perPoint * place + k] += this->Values[perPoint * i + k];
    }
  }
  for (size_t i = 0; i < n; ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[i]);
    for (size_t k = 0; counts[place] > 1 && k < perPoint; ++k)
    {
      this->Values[perPoint * i + k] =
        static_cast<float>(sums[perPoint * place + k] / counts[place]);
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
  this->Tables.Entries = {}; // done with
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
  constexpr vtkIdType mostTriangles = (vtkIdType(1) << 29) - 1;
  vtkIdType numberOfTriangles = 0;
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    numberOfTriangles += cells->GetNumberOfConnectivityIds();
  }
  if (numberOfPoints > std::numeric_limits<int>::max() ||
    input->GetNumberOfCells() > std::numeric_limits<int>::max() ||
    numberOfTriangles > 3 * mostTriangles)
  {
    this->Error = "the mesh has more points, cells or triangles than can be numbered";
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
            std::to_string(ids[i]) + " of " + std::to_string(numberOfPoints);
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
               << ") is farther than " << most << " from the middle of the mesh, more than floats "
               << (isFlat ? "hold" : "leave room for where faces are curved or displaced")
               << ": scale the mesh down";
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
    int places[3];
    for (int i = 0; i < 3; ++i)
    {
      places[i] = this->GetPlace(static_cast<int>(ids[i]));
    }
    const int pairs =
      (places[0] == places[1]) + (places[1] == places[2]) + (places[0] == places[2]);
    if (pairs > (isPatch ? 1 : 0) || !isFinite(&this->Points[3 * a]) ||
      !isFinite(&this->Points[3 * b]) || !isFinite(&this->Points[3 * c]))
    {
      ++this->NumberOfDroppedTriangles;
      return;
    }
    int order[3] = { 0, 1, 2 };
    std::sort(order, order + 3, [&places](int l, int r) { return places[l] < places[r]; });
    RefinementFace face;
    face.Cell = cell;
    face.Order = static_cast<unsigned char>(GetCornerOrderCode(order[0], order[1], order[2]));
    face.HiddenEdges = 0;
    for (int i = 0; i < 3; ++i)
    {
      face.Corners[i] = static_cast<int>(ids[order[i]]);
      // The cell's own edge i joins its corners i and i + 1: it lacks corner i + 2.
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
                  "components in [0, 1]), and the mesh has none";
    return false;
  }
  if (given->GetNumberOfComponents() < 2 || given->GetNumberOfTuples() < this->NumberOfPoints)
  {
    std::ostringstream text;
    text << "texture coordinates \"" << (given->GetName() ? given->GetName() : "") << "\" have "
         << given->GetNumberOfComponents() << " components and " << given->GetNumberOfTuples()
         << " tuples; displacement needs 2 components for each of " << this->NumberOfPoints
         << " points";
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
          this->Error = "texture coordinates of point " + std::to_string(point) + " are not finite";
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

void RefinementMesh::GetBounds(
  vtkRefinementSurface* surface, vtkDisplacement* displacement, double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  const FaceBounds faceBounds(*this, surface, displacement);
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    double low[3];
    double high[3];
    faceBounds.GetBox(f, low, high);
    for (int c = 0; c < 3; ++c)
    {
      bounds[2 * c] = f == 0 ? low[c] : std::min(bounds[2 * c], low[c]);
      bounds[2 * c + 1] = f == 0 ? high[c] : std::max(bounds[2 * c + 1], high[c]);
    }
  }
  for (int c = 0; c < 3 && !this->Faces.empty(); ++c)
  {
    bounds[2 * c] += this->Origin[c];
    bounds[2 * c + 1] += this->Origin[c];
  }
}
}
