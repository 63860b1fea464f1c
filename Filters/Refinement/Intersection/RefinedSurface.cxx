// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection/RefinedSurface.h"

#include "Boxes/BoxSegment.h"
#include "Boxes/BoxTree.h"
#include "Evaluation/HoleFinder.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Intersection/RefinedTriangles.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "Surfaces/HeightRanges.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkMath.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
// A box that contains all points of a face, regardless of their rounding.
FloatBox MakeBox(const FaceBounds& bounds, size_t face)
{
  constexpr float most = std::numeric_limits<float>::max();
  double low[3];
  double high[3];
  bounds.GetBox(face, low, high);
  FloatBox box;
  for (int c = 0; c < 3; ++c)
  {
    const double margin = 1e-6 * (std::abs(low[c]) + std::abs(high[c]) + high[c] - low[c]);
    low[c] -= margin;
    high[c] += margin;
    // Bounds that are NaN give an infinite box.
    box.Low[c] = low[c] > -most ? static_cast<float>(std::min<double>(low[c], most)) : -most;
    box.High[c] = high[c] < most ? static_cast<float>(std::max<double>(high[c], -most)) : most;
  }
  return box;
}

double GetDistance2(const FloatBox& box, const double place[3])
{
  double distance2 = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double outside = std::max({ box.Low[c] - place[c], place[c] - box.High[c], 0.0 });
    distance2 += outside * outside;
  }
  return distance2;
}
}

struct RefinedSurface::Internals
{
  const RefinementMesh* Mesh = nullptr;
  vtkDataArray* Normals = nullptr;
  std::array<vtkMTimeType, 5> Times{};
  vtkTimeStamp Time;
  vtkMTimeType HeightsTime = 0;
  vtkHeightField* Field = nullptr; // only compared, never read
  std::unique_ptr<HeightRanges> Heights;
  std::unique_ptr<RefinementEvaluator> Evaluator;
  std::unique_ptr<HoleFinder> Holes; // nullptr if there can be none
  FloatBoxTree Tree;
  std::vector<int> Positions; // in the tree, of faces

  void UpdateHeights(vtkDisplacement* displacement);
  void BuildTree(vtkAdaptiveRefinement* recipe);
  std::array<double, 3> ToLocal(const double place[3]) const
  {
    return { { place[0] - this->Mesh->Origin[0], place[1] - this->Mesh->Origin[1],
      place[2] - this->Mesh->Origin[2] } };
  }
  void Complete(const TrianglePoint& point, SurfaceHit& hit) const;
};

RefinedSurface::RefinedSurface()
  : Data(new Internals)
{
}

RefinedSurface::~RefinedSurface() = default;

void RefinedSurface::Internals::UpdateHeights(vtkDisplacement* displacement)
{
  vtkHeightField* field = displacement ? displacement->GetHeightMap() : nullptr;
  const vtkMTimeType time = field ? field->GetSamplesMTime() : 0;
  if (field != this->Field || time != this->HeightsTime)
  {
    this->Field = field;
    this->HeightsTime = time;
    this->Heights.reset(field ? new HeightRanges(field) : nullptr);
  }
}

void RefinedSurface::Internals::BuildTree(vtkAdaptiveRefinement* recipe)
{
  const FaceBounds bounds(
    *this->Mesh, recipe->GetSurface(), recipe->GetDisplacement(), this->Heights.get());
  std::vector<FloatBox> boxes(this->Mesh->Faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        boxes[face] = MakeBox(bounds, static_cast<size_t>(face));
      }
    });
  this->Tree.Build(boxes);
  this->Positions.resize(boxes.size());
  for (size_t position = 0; position < boxes.size(); ++position)
  {
    this->Positions[this->Tree.GetItem(static_cast<int>(position))] = static_cast<int>(position);
  }
}

void RefinedSurface::Update(const RefinementMesh& mesh, vtkMTimeType meshTime,
  vtkAdaptiveRefinement* recipe, vtkDataArray* normals)
{
  Internals& data = *this->Data;
  data.Mesh = &mesh;
  data.Normals = normals;
  vtkDisplacement* displacement = recipe->GetDisplacement();
  vtkRefinementSurface* surface = recipe->GetSurface();
  const auto number = [](const void* pointer)
  { return static_cast<vtkMTimeType>(reinterpret_cast<size_t>(pointer)); };
  const std::array<vtkMTimeType, 5> times = { { meshTime, number(displacement),
    displacement ? displacement->GetMTime() : 0, number(surface),
    surface ? surface->GetMTime() : 0 } };
  if (times == data.Times)
  {
    return;
  }
  data.Times = times;
  data.Time.Modified();
  data.UpdateHeights(displacement);
  data.Evaluator.reset(new RefinementEvaluator(mesh, recipe));
  const HeightValidity validity = relevo::GetHoles(recipe->GetDisplacement());
  data.Holes.reset(validity.Samples ? new HoleFinder(mesh, validity) : nullptr);
  data.BuildTree(recipe);
}

vtkMTimeType RefinedSurface::GetTime() const
{
  return this->Data->Time;
}

const RefinementEvaluator& RefinedSurface::GetEvaluator() const
{
  return *this->Data->Evaluator;
}

const HoleFinder* RefinedSurface::GetHoles() const
{
  return this->Data->Holes.get();
}

const BoundingBox<float>& RefinedSurface::GetBox(int face) const
{
  return this->Data->Tree.GetBox(this->Data->Positions[face]);
}

void RefinedSurface::Internals::Complete(const TrianglePoint& point, SurfaceHit& hit) const
{
  for (int c = 0; c < 3; ++c)
  {
    hit.Position[c] = this->Mesh->Origin[c] + point.Position[c];
    hit.Weights[c] = point.Weights[c];
    hit.Normal[c] = point.Normal[c];
  }
  if (!(vtkMath::Normalize(hit.Normal) > 0.0))
  {
    std::copy_n(point.FlatNormal, 3, hit.Normal);
  }
}

bool RefinedSurface::Intersect(const PatternSelection& selection, const double start[3],
  const double end[3], double tolerance, SurfaceHit& hit) const
{
  const Internals& data = *this->Data;
  const std::array<double, 3> from = data.ToLocal(start);
  const std::array<double, 3> to = data.ToLocal(end);
  hit.Face = -1;
  hit.T = std::nextafter(1.0, 2.0); // includes the end of the line
  TrianglePoint best;
  RefinedTriangles triangles(
    *data.Mesh, *data.Evaluator, data.Holes.get(), selection, data.Normals);
  const auto find = [&](double margin, const auto& intersect)
  {
    const BoxSegment segment(from.data(), to.data(), margin);
    data.Tree.Visit(
      hit.T, [&segment](const FloatBox& box, double last) { return segment.GetEntry(box, last); },
      [&](int face)
      {
        triangles.Refine(face);
        hit.Face = intersect(triangles, hit.T, best) ? face : hit.Face;
      });
  };
  const LineFrame frame(from.data(), to.data());
  find(0.0,
    [&frame](const RefinedTriangles& refined, double& t, TrianglePoint& point)
    { return refined.Intersect(frame, t, point); });
  if (hit.Face < 0 && tolerance > 0.0)
  {
    find(tolerance,
      [&](const RefinedTriangles& refined, double& t, TrianglePoint& point)
      { return refined.Approach(from.data(), to.data(), tolerance, t, point); });
  }
  if (hit.Face >= 0)
  {
    data.Complete(best, hit);
  }
  return hit.Face >= 0;
}

void RefinedSurface::IntersectAll(const PatternSelection& selection, const double start[3],
  const double end[3], std::vector<SurfaceHit>& hits) const
{
  // The smallest distance between two hits, relative to the length of the line. Closer hits are on
  // the common edge of two faces.
  constexpr double apart = 1e-7;
  const Internals& data = *this->Data;
  const std::array<double, 3> from = data.ToLocal(start);
  const std::array<double, 3> to = data.ToLocal(end);
  RefinedTriangles triangles(
    *data.Mesh, *data.Evaluator, data.Holes.get(), selection, data.Normals);
  hits.clear();
  this->ForEachFaceOnLine(start, end, 0.0,
    [&](int face)
    {
      triangles.Refine(face);
      // A displaced face can have several intersections: continue behind each.
      for (double passed = 0.0; passed < 1.0; passed = hits.back().T + apart)
      {
        std::array<double, 3> next;
        for (int c = 0; c < 3; ++c)
        {
          next[c] = from[c] + passed * (to[c] - from[c]);
        }
        TrianglePoint point;
        SurfaceHit hit;
        hit.Face = face;
        hit.T = std::nextafter(1.0, 2.0);
        if (!triangles.Intersect(LineFrame(next.data(), to.data()), hit.T, point))
        {
          break;
        }
        hit.T = passed + hit.T * (1.0 - passed);
        data.Complete(point, hit);
        hits.push_back(hit);
      }
    });
  std::sort(
    hits.begin(), hits.end(), [](const SurfaceHit& a, const SurfaceHit& b) { return a.T < b.T; });
  hits.erase(std::unique(hits.begin(), hits.end(),
               [](const SurfaceHit& a, const SurfaceHit& b) { return b.T - a.T <= apart; }),
    hits.end());
}

bool RefinedSurface::FindClosest(const PatternSelection& selection, const double place[3],
  double radius, SurfaceHit& hit, double& distance2) const
{
  const Internals& data = *this->Data;
  const std::array<double, 3> local = data.ToLocal(place);
  hit.Face = -1;
  distance2 = std::nextafter(radius * radius, std::numeric_limits<double>::infinity());
  TrianglePoint best;
  RefinedTriangles triangles(
    *data.Mesh, *data.Evaluator, data.Holes.get(), selection, data.Normals);
  data.Tree.Visit(
    distance2, [&local](const FloatBox& box, double) { return GetDistance2(box, local.data()); },
    [&](int face)
    {
      triangles.Refine(face);
      hit.Face = triangles.FindClosest(local.data(), distance2, best) ? face : hit.Face;
    });
  if (hit.Face >= 0)
  {
    data.Complete(best, hit);
  }
  return hit.Face >= 0;
}

bool RefinedSurface::GetCorner(int face, int corner, double position[3]) const
{
  const Internals& data = *this->Data;
  float weights[3] = { 0.0f, 0.0f, 0.0f };
  weights[corner] = 1.0f;
  float local[3];
  float normal[3];
  data.Evaluator->Evaluate(face, weights, local, normal);
  for (int c = 0; c < 3; ++c)
  {
    position[c] = data.Mesh->Origin[c] + local[c];
  }
  return !data.Holes || data.Holes->HasData(face, weights);
}

void RefinedSurface::ForEachFaceInBounds(
  const double bounds[6], const std::function<void(int)>& visit) const
{
  const Internals& data = *this->Data;
  double nearest = 0.0;
  data.Tree.Visit(
    nearest,
    [&](const FloatBox& box, double)
    {
      bool apart = false;
      for (int c = 0; c < 3; ++c)
      {
        const double origin = data.Mesh->Origin[c];
        apart =
          apart || box.Low[c] + origin > bounds[2 * c + 1] || box.High[c] + origin < bounds[2 * c];
      }
      return apart ? 1.0 : 0.0;
    },
    visit);
}

void RefinedSurface::ForEachFaceOnLine(const double start[3], const double end[3], double tolerance,
  const std::function<void(int)>& visit) const
{
  const Internals& data = *this->Data;
  const std::array<double, 3> from = data.ToLocal(start);
  const std::array<double, 3> to = data.ToLocal(end);
  const BoxSegment segment(from.data(), to.data(), tolerance);
  double last = 1.0;
  data.Tree.Visit(
    last, [&segment](const FloatBox& box, double t) { return segment.GetEntry(box, t); }, visit);
}
}
