// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/ErrorMeasure.h"

#include "Distance/DistanceBound.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr float NotMeasured = -1.0f;

void AddBall(FloatBox& box, const dvec3& centre, double radius)
{
  const vec3 low(centre - radius);
  const vec3 high(centre + radius);
  box.Add(&low.x);
  box.Add(&high.x);
}

// A float that is not less than the bound, which is at most the tolerance or infinite.
float RoundUp(double bound, double tolerance)
{
  return std::isinf(bound)
    ? std::numeric_limits<float>::infinity()
    : std::min(1.0f, std::nextafter(static_cast<float>(bound / tolerance), 2.0f));
}
}

ErrorMeasure::Grids::Grids(const MicroMesh& mesh)
  : Firsts(mesh.Faces.size() + 1, 0)
{
  const std::size_t number = mesh.Faces.size();
  for (std::size_t f = 0; f < number; ++f)
  {
    const int n = 1 << mesh.Faces[f].Level;
    this->Segments.push_back(n);
    this->Firsts[f + 1] = this->Firsts[f] + static_cast<std::size_t>(GetNumberOfGridPoints(n));
  }
  this->Points.resize(this->Firsts[number]);
  vtkSMPTools::For(0, static_cast<vtkIdType>(number),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        const std::vector<dvec3> positions = mesh.GetPositions(mesh.Faces[f]);
        std::copy(positions.begin(), positions.end(),
          this->Points.begin() + static_cast<std::ptrdiff_t>(this->Firsts[f]));
      }
    });
}

bool ErrorMeasure::Grids::HasSameFace(
  std::size_t face, const Grids& other, std::size_t otherFace) const
{
  const auto first = this->Points.begin() + static_cast<std::ptrdiff_t>(this->Firsts[face]);
  const auto last = this->Points.begin() + static_cast<std::ptrdiff_t>(this->Firsts[face + 1]);
  const std::size_t otherFirst = other.Firsts[otherFace];
  return other.Firsts[otherFace + 1] - otherFirst == static_cast<std::size_t>(last - first) &&
    std::equal(first, last, other.Points.begin() + static_cast<std::ptrdiff_t>(otherFirst));
}

FloatBox ErrorMeasure::Grids::GetBox(std::size_t face, double margin) const
{
  FloatBox box;
  for (std::size_t i = this->Firsts[face]; i < this->Firsts[face + 1]; ++i)
  {
    AddBall(box, this->Points[i], margin);
  }
  return box;
}

FloatBox ErrorMeasure::GetTriangleBox(std::size_t triangle) const
{
  FloatBox box;
  for (int vertex : this->Dense.Triangles[triangle])
  {
    const vec3 point(this->Dense.Points[static_cast<std::size_t>(vertex)]);
    box.Add(&point.x);
  }
  return box;
}

// The largest bound of those that are not infinite.
double ErrorMeasure::FindLargest(const std::vector<float>& bounds)
{
  float largest = 0.0f;
  for (float bound : bounds)
  {
    this->Failed = this->Failed || std::isinf(bound);
    largest = std::isinf(bound) ? largest : std::max(largest, bound);
  }
  return largest * this->Tolerance;
}

// Takes the bounds of faces of the last run, and finds those that are gone.
void ErrorMeasure::TakeFaceBounds(const BaseMesh& base, const MicroMesh& mesh, const Grids& grids)
{
  const std::vector<float> lastBounds = std::move(this->FaceBounds);
  this->FaceBounds.assign(mesh.Faces.size(), NotMeasured);
  this->AreGone.assign(lastBounds.size(), 1);
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const int found = this->LastFaces ? this->LastFaces->Find(base, mesh.Faces[f]) : -1;
    const auto last = static_cast<std::size_t>(found);
    if (found >= 0 && grids.HasSameFace(f, *this->LastGrids, last))
    {
      this->AreGone[last] = 0;
      this->FaceBounds[f] = lastBounds[last];
    }
    if (base.IsOriginal(mesh.Faces[f]))
    {
      this->FaceBounds[f] = 0.0f;
    }
  }
}

// Finds the triangles whose bounds are no longer valid: those that failed, and those near faces
// that are gone.
void ErrorMeasure::FindChangedTriangles(const BaseMesh& base, const MicroMesh& mesh)
{
  if (!this->LastGrids)
  {
    this->TriangleBounds.assign(this->Dense.Triangles.size(), NotMeasured);
  }
  else
  {
    std::vector<FloatBox> gone;
    for (std::size_t f = 0; f < this->AreGone.size(); ++f)
    {
      if (this->AreGone[f] != 0)
      {
        const dvec3* points = this->LastGrids->Points.data() + this->LastGrids->Firsts[f];
        ForEachGridTriangle(this->LastGrids->Segments[f],
          [&](int a, int b, int c)
          {
            gone.emplace_back();
            for (int i : { a, b, c })
            {
              AddBall(gone.back(), points[i], 2.0 * this->Tolerance);
            }
          });
      }
    }
    WideBoxTree tree;
    tree.Build(
      static_cast<int>(gone.size()), [&](int i) { return gone[static_cast<std::size_t>(i)]; });
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->TriangleBounds.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (auto t = static_cast<std::size_t>(first); t < static_cast<std::size_t>(last); ++t)
        {
          float& bound = this->TriangleBounds[t];
          bound = std::isinf(bound) ? NotMeasured : bound;
          tree.VisitIntersecting(this->GetTriangleBox(t),
            [&](int)
            {
              bound = NotMeasured;
              return false;
            });
        }
      });
  }
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    if (base.IsOriginal(mesh.Faces[f]))
    {
      this->TriangleBounds[static_cast<std::size_t>(base.Triangles[f])] = 0.0f;
    }
  }
}

void ErrorMeasure::MeasureFaces(
  const MicroMesh& mesh, const Grids& grids, const std::function<bool()>& isAborted)
{
  std::vector<float>& bounds = this->FaceBounds;
  vtkSMPTools::For(0, static_cast<vtkIdType>(bounds.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      DistanceBound measure(this->Surface, this->Tolerance);
      std::vector<DistanceBound::Corner> corners;
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        if (bounds[f] != NotMeasured || isAborted())
        {
          continue;
        }
        const dvec3* points = grids.Points.data() + grids.Firsts[f];
        const std::size_t number = grids.Firsts[f + 1] - grids.Firsts[f];
        const int n = 1 << mesh.Faces[f].Level;
        // Triangles in the middle of an edge have about the size of all.
        const auto middle = static_cast<std::size_t>(n / 2);
        const auto next = static_cast<std::size_t>(n + 1);
        const bool isSmall =
          measure.IsSmall({ { points[middle], points[middle + 1], points[middle + next] } });
        corners.clear();
        for (std::size_t p = 0; p < number && isSmall; ++p)
        {
          corners.push_back(
            measure.FindCorner(points[p], corners.empty() ? -1 : corners.back().Nearest));
        }
        double bound = 0.0;
        ForEachGridTriangle(n,
          [&](int a, int b, int c)
          {
            if (!std::isinf(bound))
            {
              const auto i = static_cast<std::size_t>(a);
              const auto j = static_cast<std::size_t>(b);
              const auto k = static_cast<std::size_t>(c);
              bound = std::max(bound,
                isSmall ? measure.Find(corners[i], corners[j], corners[k])
                        : measure.Find({ { points[i], points[j], points[k] } }));
            }
          });
        bounds[f] = RoundUp(bound, this->Tolerance);
      }
    });
  this->ResultToInput = this->FindLargest(bounds);
  this->FailedFaces.assign(bounds.size(), 0);
  for (std::size_t f = 0; f < bounds.size(); ++f)
  {
    this->FailedFaces[f] = std::isinf(bounds[f]) ? 1 : 0;
  }
}

// The faces that can be within the tolerance of triangles that are not measured.
std::vector<int> ErrorMeasure::FindFacesNearChanges(const MicroMesh& mesh, const Grids& grids) const
{
  std::vector<FloatBox> boxes;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    boxes.push_back(grids.GetBox(f, 2.0 * this->Tolerance));
  }
  std::vector<char> areNear(mesh.Faces.size(), this->LastGrids ? 0 : 1);
  if (this->LastGrids)
  {
    WideBoxTree tree;
    tree.Build(
      static_cast<int>(boxes.size()), [&](int i) { return boxes[static_cast<std::size_t>(i)]; });
    for (std::size_t t = 0; t < this->TriangleBounds.size(); ++t)
    {
      if (this->TriangleBounds[t] == NotMeasured)
      {
        tree.VisitIntersecting(this->GetTriangleBox(t),
          [&](int face)
          {
            areNear[static_cast<std::size_t>(face)] = 1;
            return true;
          });
      }
    }
  }
  std::vector<int> faces;
  for (std::size_t f = 0; f < areNear.size(); ++f)
  {
    if (areNear[f] != 0)
    {
      faces.push_back(static_cast<int>(f));
    }
  }
  return faces;
}

void ErrorMeasure::MeasureTriangles(
  const MicroMesh& mesh, const Grids& grids, const std::function<bool()>& isAborted)
{
  std::vector<TriangleTree::Triangle> triangles;
  std::vector<int> faces; // of triangles
  for (int face : this->FindFacesNearChanges(mesh, grids))
  {
    const int offset = static_cast<int>(grids.Firsts[static_cast<std::size_t>(face)]);
    ForEachGridTriangle(1 << mesh.Faces[static_cast<std::size_t>(face)].Level,
      [&](int a, int b, int c)
      {
        triangles.push_back({ { offset + a, offset + b, offset + c } });
        faces.push_back(face);
      });
  }
  const TriangleTree result(grids.Points, triangles);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->TriangleBounds.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      DistanceBound measure(result, this->Tolerance);
      int guess = -1;
      for (auto t = static_cast<std::size_t>(first); t < static_cast<std::size_t>(last); ++t)
      {
        if (this->TriangleBounds[t] != NotMeasured || isAborted())
        {
          continue;
        }
        const DenseMesh::Triangle& triangle = this->Dense.Triangles[t];
        DistanceBound::Corners corners;
        for (std::size_t c = 0; c < 3; ++c)
        {
          corners[c] = this->Dense.Points[static_cast<std::size_t>(triangle[c])];
        }
        double bound;
        if (measure.IsSmall(corners))
        {
          const DistanceBound::Corner a = measure.FindCorner(corners[0], guess);
          const DistanceBound::Corner b = measure.FindCorner(corners[1], a.Nearest);
          const DistanceBound::Corner c = measure.FindCorner(corners[2], b.Nearest);
          bound = measure.Find(a, b, c);
          guess = c.Nearest;
        }
        else
        {
          bound = measure.Find(corners);
        }
        this->TriangleBounds[t] = RoundUp(bound, this->Tolerance);
      }
    });
  this->InputToResult = this->FindLargest(this->TriangleBounds);
  this->FailedTriangles.clear();
  for (std::size_t t = 0; t < this->TriangleBounds.size(); ++t)
  {
    if (std::isinf(this->TriangleBounds[t]))
    {
      dvec3 middle(0.0);
      for (int vertex : this->Dense.Triangles[t])
      {
        middle += this->Dense.Points[static_cast<std::size_t>(vertex)] / 3.0;
      }
      double distance2 = std::numeric_limits<double>::infinity();
      int nearest = -1;
      result.FindNearest(middle, distance2, nearest);
      const int face = nearest < 0 ? -1 : faces[static_cast<std::size_t>(nearest)];
      this->FailedTriangles.emplace_back(static_cast<int>(t), face);
      if (face >= 0)
      {
        this->FailedFaces[static_cast<std::size_t>(face)] = 1;
      }
    }
  }
}

bool ErrorMeasure::Run(
  const BaseMesh& base, const MicroMesh& mesh, const std::function<bool()>& isAborted)
{
  this->Failed = false;
  auto grids = std::make_unique<Grids>(mesh);
  this->TakeFaceBounds(base, mesh, *grids);
  this->FindChangedTriangles(base, mesh);
  this->MeasureFaces(mesh, *grids, isAborted);
  if (isAborted())
  {
    return false;
  }
  this->MeasureTriangles(mesh, *grids, isAborted);
  this->LastGrids = std::move(grids);
  this->LastFaces = std::make_unique<FaceMatch>(base);
  return !isAborted();
}
}
