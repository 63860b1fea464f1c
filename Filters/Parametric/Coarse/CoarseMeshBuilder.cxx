// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Coarse/CoarseMeshBuilder.h"

#include "Coarse/CoarseNormals.h"
#include "Coarse/Diagonals.h"
#include "Coarse/PatchEdges.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <set>

namespace relevo
{
namespace
{
// A point on the border of a patch.
struct Vertex
{
  vtkIdType Point;
  dvec2 Coordinates;
  int Corner; // the nearest one
};

class Builder
{
public:
  Builder(const ControlNets& nets, const std::vector<dvec4>& points,
    const ControlPoints& homogeneous, vtkUnstructuredGrid* grid, int minimumPieces)
    : Nets(nets)
    , Patches(nets.GetPatches())
    , Homogeneous(homogeneous)
  {
    this->NumberCorners(grid);
    this->Edges = FindPatchEdges(this->Patches, points, this->MergedPoints, minimumPieces);
    this->SplitEdges();
    this->AddPatches();
    ComputeNormals(this->Patches, homogeneous, this->Mesh);
  }

  CoarseMesh Mesh;

private:
  // Numbers the grid points at corners in the order of the grid.
  void NumberCorners(vtkUnstructuredGrid* grid)
  {
    std::vector<vtkIdType> numbers(grid->GetNumberOfPoints(), -1);
    this->Corners.resize(this->Patches.size());
    for (std::size_t i = 0; i < this->Patches.size(); ++i)
    {
      for (int k = 0; k < this->Patches[i].GetNumberOfCorners(); ++k)
      {
        this->Corners[i][k] = this->Nets.GetCornerPoint(i, k);
        numbers[this->Corners[i][k]] = 0;
      }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      if (numbers[i] == 0)
      {
        CoarsePoint point;
        point.GridPoint = static_cast<vtkIdType>(i);
        grid->GetPoint(point.GridPoint, &point.Place.x);
        numbers[i] = this->AddPoint(point);
      }
    }
    const std::vector<vtkIdType> places = FindPlaces(this->Mesh.Points);
    this->MergedPoints.resize(this->Patches.size());
    for (std::size_t i = 0; i < this->Patches.size(); ++i)
    {
      for (int k = 0; k < this->Patches[i].GetNumberOfCorners(); ++k)
      {
        this->Corners[i][k] = numbers[this->Corners[i][k]];
        this->MergedPoints[i][k] = places[this->Corners[i][k]];
      }
    }
  }

  vtkIdType AddPoint(const CoarsePoint& point)
  {
    this->Mesh.Points.push_back(point);
    return static_cast<vtkIdType>(this->Mesh.Points.size()) - 1;
  }

  vtkIdType AddInnerPoint(std::size_t patch, const dvec2& uv)
  {
    CoarsePoint point;
    point.Place = EvaluatePoint(this->Patches[patch], this->Homogeneous, uv);
    point.GridPoint = this->Mesh.Points[this->Corners[patch][0]].GridPoint;
    point.Patch = patch;
    point.Coordinates = uv;
    point.IsNode = false;
    return this->AddPoint(point);
  }

  // Places the points that split an edge so that they coincide with no other point.
  void SplitEdges()
  {
    const auto isSplit = [](const PatchEdge& edge) { return edge.Pieces > 1; };
    if (std::none_of(this->Edges.Edges.begin(), this->Edges.Edges.end(), isSplit))
    {
      return;
    }
    std::set<std::array<double, 3>> taken;
    for (const CoarsePoint& point : this->Mesh.Points)
    {
      taken.insert({ point.Place.x, point.Place.y, point.Place.z });
    }
    for (std::size_t i = 0; i < this->Edges.Edges.size(); ++i)
    {
      for (int k = 1; k < this->Edges.Edges[i].Pieces; ++k)
      {
        this->AddSplit(static_cast<int>(i), k, taken);
      }
    }
  }

  void AddSplit(int index, int piece, std::set<std::array<double, 3>>& taken)
  {
    const PatchEdge& edge = this->Edges.Edges[index];
    const ControlPoints curve = GetCurve(edge, this->Patches, this->Homogeneous);
    const FacePatch& patch = this->Patches[edge.Patch];
    double t = piece / static_cast<double>(edge.Pieces);
    dvec3 place = EvaluateCurve(curve, t);
    constexpr double step = 1.0 / 64.0;
    for (int tries = 0; tries < 8 && taken.count({ place.x, place.y, place.z }); ++tries)
    {
      t += step;
      place = EvaluateCurve(curve, t);
    }
    taken.insert({ place.x, place.y, place.z });
    CoarsePoint point;
    point.Place = place;
    point.GridPoint = this->Mesh.Points[this->Corners[edge.Patch][edge.Border]].GridPoint;
    point.Patch = edge.Patch;
    point.Coordinates =
      this->GetBorderCoordinates(patch, edge.Border, edge.IsReversed ? 1.0 - t : t);
    point.IsNode = false;
    this->Splits[index].push_back({ t, this->AddPoint(point) });
  }

  static dvec2 GetBorderCoordinates(const FacePatch& patch, int border, double t)
  {
    const dvec2 start = patch.GetCorner(border);
    const dvec2 end = patch.GetCorner((border + 1) % patch.GetNumberOfCorners());
    return (1.0 - t) * start + t * end;
  }

  const PatchEdge& GetEdge(std::size_t patch, int border) const
  {
    return this->Edges.Edges[this->Edges.Borders[patch][border].Edge];
  }

  bool HasEdge(std::size_t patch, bool (*is)(const PatchEdge&)) const
  {
    bool has = false;
    for (int border = 0; border < this->Patches[patch].GetNumberOfCorners(); ++border)
    {
      has = has || is(this->GetEdge(patch, border));
    }
    return has;
  }

  // Whether two borders of the patch coincide, as at the seam of a sphere. An inner point would
  // then be connected twice to the merged points on it.
  bool IntersectsItself(std::size_t patch) const
  {
    const std::array<PatchBorder, 4>& borders = this->Edges.Borders[patch];
    bool isRepeated = false;
    for (int a = 0; a < this->Patches[patch].GetNumberOfCorners(); ++a)
    {
      for (int b = 0; b < a; ++b)
      {
        isRepeated = isRepeated ||
          (borders[a].Edge == borders[b].Edge && !this->GetEdge(patch, a).IsCollapsed);
      }
    }
    return isRepeated;
  }

  // Returns the point at a corner of a patch. The corners of a degenerate border coincide, but are
  // different points. Each one belongs to the adjacent border that ends there, so that neighbours
  // around a pole share it.
  vtkIdType GetCornerPoint(std::size_t patch, int corner)
  {
    const int size = this->Patches[patch].GetNumberOfCorners();
    const int before = (corner + size - 1) % size;
    const bool isAfter = this->GetEdge(patch, before).IsCollapsed;
    if (!isAfter && !this->GetEdge(patch, corner).IsCollapsed)
    {
      return this->Corners[patch][corner];
    }
    const int other = isAfter ? corner : before;
    const PatchBorder border = this->Edges.Borders[patch][other];
    // A patch that surrounds the pole has the same border on both sides.
    const int round = isAfter ? (corner + size - 2) % size : -1;
    const bool isRound = isAfter && this->Edges.Borders[patch][round].Edge == border.Edge;
    return this->GetPole(
      { this->MergedPoints[patch][corner], border.Edge, isRound }, this->Corners[patch][corner]);
  }

  vtkIdType GetPole(const std::array<vtkIdType, 3>& key, vtkIdType corner)
  {
    const auto [pole, isNew] = this->Poles.insert({ key, corner });
    if (isNew && !this->UsedPoles.insert(corner).second)
    {
      pole->second = this->AddPoint(CoarsePoint(this->Mesh.Points[corner]));
    }
    return pole->second;
  }

  std::vector<Vertex> GetVertices(std::size_t index)
  {
    const FacePatch& patch = this->Patches[index];
    std::vector<Vertex> vertices;
    for (int border = 0; border < patch.GetNumberOfCorners(); ++border)
    {
      vertices.push_back({ this->GetCornerPoint(index, border), patch.GetCorner(border), border });
      const PatchBorder& use = this->Edges.Borders[index][border];
      const auto found = this->Splits.find(use.Edge);
      if (found == this->Splits.end())
      {
        continue;
      }
      std::vector<std::pair<double, vtkIdType>> splits = found->second;
      if (use.IsReversed)
      {
        std::reverse(splits.begin(), splits.end());
      }
      for (const auto& [share, point] : splits)
      {
        const double t = use.IsReversed ? 1.0 - share : share;
        const int nearest = t <= 0.5 ? border : (border + 1) % patch.GetNumberOfCorners();
        vertices.push_back({ point, this->GetBorderCoordinates(patch, border, t), nearest });
      }
    }
    return vertices;
  }

  void AddTriangle(std::size_t patch, const Vertex& a, const Vertex& b, const Vertex& c)
  {
    this->Mesh.Triangles.push_back(
      { patch, { a.Point, b.Point, c.Point }, { a.Coordinates, b.Coordinates, c.Coordinates } });
  }

  void AddFan(std::size_t patch, const std::vector<Vertex>& vertices)
  {
    const dvec2 uv = this->Patches[patch].GetMiddle();
    const Vertex middle{ this->AddInnerPoint(patch, uv), uv, 0 };
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->AddTriangle(patch, middle, vertices[i], vertices[(i + 1) % vertices.size()]);
    }
  }

  // Triangulates around an inner point near each corner, so that no inner point is connected twice
  // to the same merged point.
  void AddRing(std::size_t patch, const std::vector<Vertex>& vertices)
  {
    const FacePatch& shape = this->Patches[patch];
    std::vector<Vertex> inner;
    for (int k = 0; k < shape.GetNumberOfCorners(); ++k)
    {
      const dvec2 uv = 0.5 * (shape.GetCorner(k) + shape.GetMiddle());
      inner.push_back({ this->AddInnerPoint(patch, uv), uv, k });
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const Vertex& next = vertices[(i + 1) % vertices.size()];
      const Vertex& near = inner[vertices[i].Corner];
      this->AddTriangle(patch, near, vertices[i], next);
      if (next.Corner != vertices[i].Corner)
      {
        this->AddTriangle(patch, near, next, inner[next.Corner]);
      }
    }
    this->AddTriangle(patch, inner[0], inner[1], inner[2]);
    if (inner.size() == 4)
    {
      this->AddTriangle(patch, inner[0], inner[2], inner[3]);
    }
  }

  void AddSplitPatch(std::size_t patch, const std::vector<Vertex>& vertices)
  {
    const CornerPoints& places = this->MergedPoints[patch];
    const int size = this->Patches[patch].GetNumberOfCorners();
    bool isPlaceRepeated = this->IntersectsItself(patch);
    for (int a = 0; a < size; ++a)
    {
      for (int b = a + 1; b < size; ++b)
      {
        const bool isCollapsed = (b == a + 1 && this->GetEdge(patch, a).IsCollapsed) ||
          (a == 0 && b == size - 1 && this->GetEdge(patch, b).IsCollapsed);
        isPlaceRepeated = isPlaceRepeated || (places[a] == places[b] && !isCollapsed);
      }
    }
    isPlaceRepeated ? this->AddRing(patch, vertices) : this->AddFan(patch, vertices);
  }

  void AddPatches()
  {
    std::vector<Diagonal> diagonals(this->Patches.size(), Diagonal::None);
    for (std::size_t i = 0; i < this->Patches.size(); ++i)
    {
      const bool isWhole = !this->IntersectsItself(i) &&
        !this->HasEdge(i, [](const PatchEdge& edge) { return edge.Pieces > 1; });
      const bool isPole = this->HasEdge(i, [](const PatchEdge& edge) { return edge.IsCollapsed; });
      if (isWhole && !this->Patches[i].IsTriangle)
      {
        diagonals[i] = isPole ? Diagonal::Fixed : Diagonal::First;
      }
    }
    ChooseDiagonals(this->Edges, this->MergedPoints, diagonals);
    for (std::size_t i = 0; i < this->Patches.size(); ++i)
    {
      const std::vector<Vertex> v = this->GetVertices(i);
      if (v.size() == 3 && !this->IntersectsItself(i))
      {
        this->AddTriangle(i, v[0], v[1], v[2]);
      }
      else if (diagonals[i] == Diagonal::None)
      {
        this->AddSplitPatch(i, v);
      }
      else
      {
        const bool isSecond = diagonals[i] == Diagonal::Second;
        this->AddTriangle(i, v[0], v[1], isSecond ? v[3] : v[2]);
        this->AddTriangle(i, isSecond ? v[1] : v[0], v[2], v[3]);
      }
    }
  }

  const ControlNets& Nets;
  const std::vector<FacePatch>& Patches;
  const ControlPoints& Homogeneous;
  std::vector<std::array<vtkIdType, 4>> Corners; // point indices
  std::vector<CornerPoints> MergedPoints;
  PatchEdges Edges;
  std::map<int, std::vector<std::pair<double, vtkIdType>>> Splits; // for each edge the parameters
                                                                   // and points
  std::map<std::array<vtkIdType, 3>, vtkIdType> Poles;             // by merged point and border
  std::set<vtkIdType> UsedPoles;
};
}

CoarseMesh BuildCoarseMesh(const ControlNets& nets, const std::vector<dvec4>& points,
  const ControlPoints& homogeneous, vtkUnstructuredGrid* grid, int minimumPieces)
{
  Builder builder(nets, points, homogeneous, grid, minimumPieces);
  return std::move(builder.Mesh);
}
}
