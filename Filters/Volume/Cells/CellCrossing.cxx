// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellCrossing.h"

#include "Bezier/BezierCrossing.h"
#include "Boxes/BoxSegment.h"
#include "Cells/CurvedScalars.h"
#include "Cells/PointGradients.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace relevo
{
namespace
{
// Relative to the diagonal of the mesh. Boxes are float.
constexpr double BoxMargin = 1e-6;
constexpr double PlaneMargin = 1e-12;
constexpr size_t TypicalParts = 128; // of a ray

void AddWeighed(const Scalars& scalars, double weight, Scalars& sum)
{
  for (size_t c = 0; c < scalars.size(); ++c)
  {
    sum[c] += weight * scalars[c];
  }
}

FloatBox RoundBox(const dvec3& low, const dvec3& high)
{
  FloatBox rounded;
  for (int c = 0; c < 3; ++c)
  {
    rounded.Low[c] = static_cast<float>(low[c]);
    rounded.High[c] = static_cast<float>(high[c]);
  }
  return rounded;
}

FloatBox GetBox(const CurvedPart& part)
{
  dvec3 low;
  dvec3 high;
  part.Shape.FindBounds(low, high);
  return RoundBox(low, high);
}

FloatBox GetBox(const VolumeCells& cells, const VolumeCells::Cell& cell)
{
  dvec3 low;
  dvec3 high;
  if (cell.Shape)
  {
    cells.GetCurved(cell).FindBounds(low, high);
  }
  else
  {
    const TetrahedronCorners corners = cells.GetTetrahedron(cell);
    low = min(min(corners[0], corners[1]), min(corners[2], corners[3]));
    high = max(max(corners[0], corners[1]), max(corners[2], corners[3]));
  }
  return RoundBox(low, high);
}
}

CellCrossing::CellCrossing(VolumeCells& cells, bool withSteepness, bool withGradients)
  : Cells(cells)
  , HasSteepness(withSteepness)
  , HasGradients(withGradients)
{
  cells.MoveToOrigin();
  if (withGradients)
  {
    this->PointGradients = ComputePointGradients(cells);
  }
}

void CellCrossing::BuildTree()
{
  std::vector<FloatBox> boxes;
  boxes.reserve(this->Cells.GetCells().size() + this->Cells.GetCurvedParts().size());
  for (const VolumeCells::Cell& cell : this->Cells.GetCells())
  {
    boxes.push_back(GetBox(this->Cells, cell));
  }
  for (const CurvedPart& part : this->Cells.GetCurvedParts())
  {
    boxes.push_back(GetBox(part));
  }
  this->Tree.Build(boxes);
}

double CellCrossing::GetShortest() const
{
  return PlaneMargin * this->Cells.GetDiagonal();
}

Scalars CellCrossing::GetLengths(const Gradients& gradients) const
{
  Scalars lengths;
  std::transform(gradients.begin(), gradients.end(), lengths.begin(),
    [this](const dvec3& gradient) { return length(this->GradientTransform * gradient); });
  return lengths;
}

void CellCrossing::CrossTetrahedron(
  const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const
{
  TetrahedronCrossing crossing;
  if (!TetrahedronPlanes(this->Cells.GetTetrahedron(cell))
         .Cross(ray, this->GetShortest(), crossing))
  {
    return;
  }
  RayPart part = { crossing.Begin, crossing.End, {}, {} };
  if (cell.Scalars >= 0)
  {
    part.Front = part.Back = this->Cells.GetCellScalars()[cell.Scalars];
  }
  for (int i = 0; i < 4 && cell.Scalars < 0; ++i)
  {
    const Scalars& scalars = this->Cells.GetPointScalars()[this->Cells.GetCornerId(cell, i)];
    AddWeighed(scalars, crossing.FrontWeights[i], part.Front);
    AddWeighed(scalars, crossing.BackWeights[i], part.Back);
  }
  if (this->HasSteepness && cell.Scalars < 0)
  {
    CornerSlopes slopes;
    ComputeSlopes(this->Cells.GetTetrahedron(cell), slopes);
    part.Steepness = this->ComputeSteepness(cell, slopes);
  }
  if (!this->PointGradients.empty() && cell.Scalars < 0)
  {
    part.FrontGradients = this->WeighGradients(cell, &crossing.FrontWeights.x);
    part.BackGradients = this->WeighGradients(cell, &crossing.BackWeights.x);
  }
  parts.push_back(part);
}

void CellCrossing::CrossCurved(
  const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const
{
  const CurvedCell curved = this->Cells.GetCurved(cell);
  const std::vector<std::pair<double, double>> inside = curved.FindInside(ray, this->GetShortest());
  if (inside.empty())
  {
    return;
  }
  if (cell.Scalars >= 0)
  {
    const Scalars& scalars = this->Cells.GetCellScalars()[cell.Scalars];
    for (const auto& interval : inside)
    {
      parts.push_back({ interval.first, interval.second, scalars, scalars });
    }
    return;
  }
  std::vector<Scalars> scalars;
  for (int i = 0; i < cell.Shape->NumberOfCorners; ++i)
  {
    scalars.push_back(this->Cells.GetPointScalars()[this->Cells.GetCornerId(cell, i)]);
  }
  dvec3 parameters = curved.GetCenter();
  const CurvedScalars along(
    [&](double at)
    {
      const CornerWeights weights = curved.GetWeights(ray.Origin + at * ray.Direction, parameters);
      Scalars sum = {};
      for (size_t i = 0; i < scalars.size(); ++i)
      {
        AddWeighed(scalars[i], weights[i], sum);
      }
      return sum;
    },
    scalars);
  const size_t first = parts.size();
  for (const auto& interval : inside)
  {
    along.Split(interval.first, interval.second, parts);
  }
  const auto getWeights = [&](double at)
  { return curved.GetWeights(ray.Origin + at * ray.Direction, parameters); };
  for (size_t i = first; i < parts.size() && this->HasSteepness; ++i)
  {
    CornerSlopes slopes;
    getWeights(0.5 * (parts[i].Begin + parts[i].End)); // also updates the parameters
    curved.ComputeSlopes(parameters, slopes);
    parts[i].Steepness = this->ComputeSteepness(cell, slopes);
  }
  for (size_t i = first; i < parts.size() && !this->PointGradients.empty(); ++i)
  {
    parts[i].FrontGradients = this->WeighGradients(cell, getWeights(parts[i].Begin).data());
    parts[i].BackGradients = this->WeighGradients(cell, getWeights(parts[i].End).data());
  }
}

Scalars CellCrossing::ComputeSteepness(
  const VolumeCells::Cell& cell, const CornerSlopes& slopes) const
{
  return this->GetLengths(this->Cells.ComputeGradients(cell, slopes));
}

// Gradients are those of the part's own basis.
void CellCrossing::CrossPart(
  const CurvedPart& part, const Ray& ray, std::vector<RayPart>& parts) const
{
  if (part.IsGhost)
  {
    return;
  }
  const BezierCrossing crossing(part.Shape);
  const std::vector<std::pair<double, double>> inside =
    crossing.FindInside(ray, this->GetShortest());
  if (part.Scalars >= 0)
  {
    const Scalars& scalars = this->Cells.GetCellScalars()[part.Scalars];
    for (const auto& interval : inside)
    {
      parts.push_back({ interval.first, interval.second, scalars, scalars });
    }
    return;
  }
  std::vector<Scalars> range(2);
  for (int c = 0; c < part.Shape.GetNumberOfScalars(); ++c)
  {
    part.Shape.FindRange(c, range[0][c], range[1][c]);
  }
  dvec3 parameters(0.5);
  const auto locate = [&](double at)
  {
    crossing.Locate(ray.Origin + at * ray.Direction, parameters);
    return parameters;
  };
  const CurvedScalars along(
    [&](double at) { return part.Shape.Evaluate(locate(at)).Values; }, range);
  const size_t first = parts.size();
  for (const auto& interval : inside)
  {
    along.Split(interval.first, interval.second, parts);
  }
  for (size_t i = first; i < parts.size() && this->HasSteepness; ++i)
  {
    parts[i].Steepness =
      this->GetLengths(part.Shape.ComputeGradients(locate(0.5 * (parts[i].Begin + parts[i].End))));
  }
  for (size_t i = first; i < parts.size() && this->HasGradients; ++i)
  {
    parts[i].FrontGradients = part.Shape.ComputeGradients(locate(parts[i].Begin));
    parts[i].BackGradients = part.Shape.ComputeGradients(locate(parts[i].End));
  }
}

Gradients CellCrossing::WeighGradients(const VolumeCells::Cell& cell, const double* weights) const
{
  Gradients sum = {};
  for (int i = 0; i < this->Cells.GetNumberOfCorners(cell); ++i)
  {
    const Gradients& gradients = this->PointGradients[this->Cells.GetCornerId(cell, i)];
    for (size_t c = 0; c < sum.size(); ++c)
    {
      sum[c] += weights[i] * gradients[c];
    }
  }
  return sum;
}

void CellCrossing::AppendParts(size_t number, const Ray& ray, std::vector<RayPart>& parts) const
{
  const size_t whole = this->Cells.GetCells().size();
  if (number >= whole)
  {
    this->CrossPart(this->Cells.GetCurvedParts()[number - whole], ray, parts);
    return;
  }
  const VolumeCells::Cell& cell = this->Cells.GetCells()[number];
  cell.Shape ? this->CrossCurved(cell, ray, parts) : this->CrossTetrahedron(cell, ray, parts);
}

Scalars CellCrossing::Evaluate(size_t number, const dvec3& point) const
{
  const dvec3 at = point - this->Cells.GetMiddle();
  const size_t whole = this->Cells.GetCells().size();
  if (number >= whole)
  {
    const CurvedPart& part = this->Cells.GetCurvedParts()[number - whole];
    if (part.Scalars >= 0)
    {
      return this->Cells.GetCellScalars()[part.Scalars];
    }
    dvec3 parameters(0.5);
    BezierCrossing(part.Shape).Locate(at, parameters);
    return part.Shape.Evaluate(parameters).Values;
  }
  const VolumeCells::Cell& cell = this->Cells.GetCells()[number];
  if (cell.Scalars >= 0)
  {
    return this->Cells.GetCellScalars()[cell.Scalars];
  }
  CornerWeights weights = {};
  if (cell.Shape)
  {
    dvec3 parameters = cell.Shape->Center;
    weights = this->Cells.GetCurved(cell).GetWeights(at, parameters);
  }
  else
  {
    const TetrahedronCorners corners = this->Cells.GetTetrahedron(cell);
    const dvec3 center = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    CornerSlopes slopes;
    ComputeSlopes(corners, slopes);
    for (int i = 0; i < 4; ++i)
    {
      weights[i] = 0.25 + dot(slopes[i], at - center);
    }
  }
  Scalars sum = {};
  for (int i = 0; i < this->Cells.GetNumberOfCorners(cell); ++i)
  {
    AddWeighed(this->Cells.GetPointScalars()[this->Cells.GetCornerId(cell, i)], weights[i], sum);
  }
  return sum;
}

Gradients CellCrossing::ComputeGradients(size_t number, const dvec3& point) const
{
  const dvec3 at = point - this->Cells.GetMiddle();
  const size_t whole = this->Cells.GetCells().size();
  if (number >= whole)
  {
    const CurvedPart& part = this->Cells.GetCurvedParts()[number - whole];
    dvec3 parameters(0.5);
    BezierCrossing(part.Shape).Locate(at, parameters);
    return part.Scalars >= 0 ? Gradients{} : part.Shape.ComputeGradients(parameters);
  }
  const VolumeCells::Cell& cell = this->Cells.GetCells()[number];
  if (cell.Scalars >= 0)
  {
    return {};
  }
  CornerSlopes slopes;
  if (cell.Shape)
  {
    const CurvedCell curved = this->Cells.GetCurved(cell);
    dvec3 parameters = curved.GetCenter();
    curved.GetWeights(at, parameters);
    curved.ComputeSlopes(parameters, slopes);
  }
  else
  {
    ComputeSlopes(this->Cells.GetTetrahedron(cell), slopes);
  }
  return this->Cells.ComputeGradients(cell, slopes);
}

std::vector<RayPart> CellCrossing::Cross(const Ray& ray) const
{
  if (!(ray.Length > 0.0))
  {
    return {};
  }
  const Ray moved = { ray.Origin - this->Cells.GetMiddle(), ray.Direction, ray.Length };
  const dvec3 end = moved.Origin + moved.Length * moved.Direction;
  const BoxSegment segment(&moved.Origin.x, &end.x, BoxMargin * this->Cells.GetDiagonal());
  std::vector<int> candidates;
  candidates.reserve(TypicalParts);
  double last = 1.0;
  this->Tree.Visit(
    last, [&](const FloatBox& box, double nearest) { return segment.GetEntry(box, nearest); },
    [&](int index) { candidates.push_back(index); });
  return this->Cross(ray, candidates);
}

std::vector<RayPart> CellCrossing::Cross(const Ray& ray, const std::vector<int>& candidates) const
{
  if (!(ray.Length > 0.0))
  {
    return {};
  }
  const Ray moved = { ray.Origin - this->Cells.GetMiddle(), ray.Direction, ray.Length };
  std::vector<RayPart> parts;
  parts.reserve(TypicalParts);
  for (const int candidate : candidates)
  {
    const size_t number = static_cast<size_t>(candidate);
    const size_t first = parts.size();
    this->AppendParts(number, moved, parts);
    for (size_t i = first; i < parts.size(); ++i)
    {
      parts[i].Cell = number;
    }
  }
  // Parts are too large to be sorted themselves.
  std::vector<size_t> order(parts.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::sort(order.begin(), order.end(),
    [&](size_t first, size_t last)
    {
      const RayPart& a = parts[first];
      const RayPart& b = parts[last];
      return a.Begin < b.Begin ||
        (a.Begin == b.Begin && (a.End < b.End || (a.End == b.End && a.Cell < b.Cell)));
    });

  // A ray in a face is in both cells. Overlaps must be counted once.
  double reached = 0.0;
  std::vector<RayPart> once;
  once.reserve(parts.size());
  for (const size_t number : order)
  {
    const RayPart& part = parts[number];
    if (part.End > reached)
    {
      const double hidden = (reached - part.Begin) / (part.End - part.Begin);
      once.push_back(hidden > 0.0 ? part.Cut(hidden, 1.0) : part);
      reached = part.End;
    }
  }
  return once;
}
}
