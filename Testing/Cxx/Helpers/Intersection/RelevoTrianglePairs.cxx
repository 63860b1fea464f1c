// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoTrianglePairs.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>

namespace
{
using Vector = RelevoWholePoint;

Vector Subtract(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

std::int64_t Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector GetNormal(const std::vector<Vector>& p)
{
  return p.size() < 3 ? Vector{} : Cross(Subtract(p[1], p[0]), Subtract(p[2], p[0]));
}

std::vector<Vector> GetEdges(const std::vector<Vector>& p)
{
  std::vector<Vector> edges;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
  {
    edges.push_back(Subtract(p[i + 1], p[i]));
  }
  if (p.size() == 3)
  {
    edges.push_back(Subtract(p[0], p[2]));
  }
  return edges;
}

// Gap between the projections on an axis; negative if they overlap.
std::int64_t GetGap(const Vector& axis, const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  const auto getRange = [&axis](const std::vector<Vector>& points)
  {
    std::array<std::int64_t, 2> range{ Dot(axis, points[0]), Dot(axis, points[0]) };
    for (const Vector& point : points)
    {
      range = { std::min(range[0], Dot(axis, point)), std::max(range[1], Dot(axis, point)) };
    }
    return range;
  };
  const auto aRange = getRange(a);
  const auto bRange = getRange(b);
  return std::max(bRange[0] - aRange[1], aRange[0] - bRange[1]);
}

// If convex hulls do not intersect, a facet of their Minkowski difference separates them. It is
// parallel to an edge of each, to the plane of one, or, if both are coplanar, to an edge within the
// plane.
std::vector<Vector> GetAxes(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  const Vector normals[2] = { GetNormal(a), GetNormal(b) };
  const std::vector<Vector> edges[2] = { GetEdges(a), GetEdges(b) };
  std::vector<Vector> axes{ normals[0], normals[1] };
  for (const Vector& e : edges[0])
  {
    for (const Vector& f : edges[1])
    {
      axes.push_back(Cross(e, f));
    }
  }
  for (const auto& own : edges)
  {
    for (const Vector& edge : own)
    {
      axes.push_back(Cross(normals[0], edge));
      axes.push_back(Cross(normals[1], edge));
    }
  }
  return axes;
}
}

RelevoWholeMesh::RelevoWholeMesh(
  RelevoDice& dice, int side, int numberOfPoints, int numberOfTriangles)
{
  while (static_cast<int>(this->Points.size()) < numberOfPoints)
  {
    const Vector point{ dice.Throw(side), dice.Throw(side), dice.Throw(side) };
    if (std::find(this->Points.begin(), this->Points.end(), point) == this->Points.end())
    {
      this->Points.push_back(point);
    }
  }
  while (static_cast<int>(this->Triangles.size()) < numberOfTriangles)
  {
    this->Triangles.push_back(
      { dice.Throw(numberOfPoints), dice.Throw(numberOfPoints), dice.Throw(numberOfPoints) });
    const int last = static_cast<int>(this->Triangles.size()) - 1;
    if (GetNormal(this->GetCorners(last)) == Vector{})
    {
      this->Triangles.pop_back();
    }
  }
}

vtkSmartPointer<vtkPolyData> RelevoWholeMesh::NewPolyData() const
{
  vtkNew<vtkPoints> points;
  for (const Vector& point : this->Points)
  {
    points->InsertNextPoint(
      static_cast<double>(point[0]), static_cast<double>(point[1]), static_cast<double>(point[2]));
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& triangle : this->Triangles)
  {
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

std::vector<RelevoWholePoint> RelevoWholeMesh::GetCorners(int triangle) const
{
  std::vector<Vector> corners;
  for (int corner : this->Triangles[triangle])
  {
    corners.push_back(this->Points[corner]);
  }
  return corners;
}

bool RelevoMeet(const std::vector<RelevoWholePoint>& a, const std::vector<RelevoWholePoint>& b)
{
  const std::vector<Vector> axes = GetAxes(a, b);
  return std::none_of(
    axes.begin(), axes.end(), [&](const Vector& axis) { return GetGap(axis, a, b) > 0; });
}

bool RelevoCross(const std::vector<RelevoWholePoint>& a, const std::vector<RelevoWholePoint>& b)
{
  const std::vector<Vector> axes = GetAxes(a, b);
  return std::none_of(axes.begin(), axes.end(),
    [&](const Vector& axis) { return axis != Vector{} && GetGap(axis, a, b) >= 0; });
}

bool RelevoMeetBeyond(const RelevoWholeMesh& mesh, int first, int second)
{
  const auto& a = mesh.Triangles[first];
  const auto& b = mesh.Triangles[second];
  std::vector<int> shared;
  std::vector<int> others[2];
  for (int corner : a)
  {
    (std::count(b.begin(), b.end(), corner) != 0 ? shared : others[0]).push_back(corner);
  }
  for (int corner : b)
  {
    if (std::count(a.begin(), a.end(), corner) == 0)
    {
      others[1].push_back(corner);
    }
  }
  const auto aCorners = mesh.GetCorners(first);
  const auto bCorners = mesh.GetCorners(second);
  if (shared.size() == 2)
  {
    // Coplanar, and on the same side of the edge.
    const Vector edge = Subtract(mesh.Points[shared[1]], mesh.Points[shared[0]]);
    const Vector own = Cross(edge, Subtract(mesh.Points[others[0][0]], mesh.Points[shared[0]]));
    const Vector other = Cross(edge, Subtract(mesh.Points[others[1][0]], mesh.Points[shared[0]]));
    return Cross(own, other) == Vector{} && Dot(own, other) > 0;
  }
  if (shared.size() == 1)
  {
    // From the shared corner through any other common point, both continue until one ends at its
    // opposite edge.
    const auto getEdge = [&mesh](const std::vector<int>& ends) {
      return std::vector<Vector>{ mesh.Points[ends[0]], mesh.Points[ends[1]] };
    };
    return RelevoMeet(getEdge(others[0]), bCorners) || RelevoMeet(getEdge(others[1]), aCorners);
  }
  return shared.size() == 3 || RelevoMeet(aCorners, bCorners);
}
