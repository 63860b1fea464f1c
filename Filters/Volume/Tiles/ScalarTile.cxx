// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles/ScalarTile.h"

#include "Cells/TetrahedronCrossing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relevo
{
namespace
{
// The largest error of a scalar: a share of the scalars of the cell, or the change that changes
// colour or opacity by this much. Segments have the right mean, so that the error of a picture is
// much smaller.
constexpr double ScalarTolerance = 1.0 / 8192.0;
constexpr double ColorTolerance = 1.0 / 2048.0;
// The squared deviation of parameters from a straight line, below which scalars are cubic.
constexpr double Straight = 1e-5;
constexpr int MostSegments = 64;
constexpr size_t MostMoves = 16; // of each part while the parts are sorted by insertion
constexpr double OpaqueAlpha = 1.0 - 1e-14;

// A cubic by its values at thirds.
class Cubic
{
public:
  explicit Cubic(const std::array<double, 4>& values)
    : Values(values)
  {
  }
  double Evaluate(double x) const
  {
    const double a = x - 1.0 / 3.0;
    const double b = x - 2.0 / 3.0;
    const double c = x - 1.0;
    const auto& v = this->Values;
    return 4.5 * (x * a * b * v[3] - a * b * c * v[0]) +
      13.5 * (x * b * c * v[1] - x * a * c * v[2]);
  }
  // The second derivative is linear, and the largest at an end.
  int CountSegments(double tolerance) const
  {
    const auto& v = this->Values;
    const double first = 9.0 * std::abs(2.0 * v[0] - 5.0 * v[1] + 4.0 * v[2] - v[3]);
    const double last = 9.0 * std::abs(2.0 * v[3] - 5.0 * v[2] + 4.0 * v[1] - v[0]);
    const double count = std::ceil(std::sqrt(std::max(first, last) / (8.0 * tolerance)));
    return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(MostSegments))); // NaN: 1
  }

private:
  std::array<double, 4> Values;
};

// Whether parameters at thirds are nearly on a straight line.
bool AreStraight(const std::array<dvec3, 4>& p)
{
  const dvec3 first = p[0] - 2.0 * p[1] + p[2];
  const dvec3 last = p[1] - 2.0 * p[2] + p[3];
  return std::max(dot(first, first), dot(last, last)) < Straight;
}
}

void ScalarTile::Cast(int tile, const std::vector<Ray>& rays, std::vector<dvec4>& colors)
{
  this->Bounds = this->Pixels.GetTile(tile);
  this->Rays.resize(std::max(this->Rays.size(), rays.size()));
  for (size_t i = 0; i < rays.size(); ++i)
  {
    Pixel& pixel = this->Rays[i];
    pixel.Way = rays[i];
    pixel.Way.Origin -= this->Crossing.GetCells().GetMiddle();
    pixel.Across = AcrossRay(rays[i].Direction);
    pixel.Parts.clear();
  }
  for (const int cell : this->Pixels.FindCells(tile))
  {
    this->AddCell(cell);
  }
  colors.resize(rays.size());
  for (size_t i = 0; i < rays.size(); ++i)
  {
    colors[i] = this->Blend(this->Rays[i]);
  }
}

// Calls visit(pixel) for the pixels of a cell whose rays are not empty.
template <typename Visitor>
void ScalarTile::VisitPixels(int number, const Visitor& visit)
{
  this->Pixels.FindOutline(number, this->Outline);
  this->Bounds.Visit(this->Outline,
    [&](size_t index)
    {
      Pixel& pixel = this->Rays[index];
      if (pixel.Way.Length > 0.0)
      {
        visit(pixel);
      }
    });
}

void ScalarTile::AddCell(int number)
{
  const VolumeCellList& cells = this->Crossing.GetCells().GetCells();
  const bool isWhole = static_cast<size_t>(number) < cells.size();
  const VolumeCells::Cell cell = isWhole ? cells[static_cast<size_t>(number)] : VolumeCells::Cell();
  const HexahedronCrossing::Corners* corners =
    isWhole && cell.Shape ? HexahedronCrossing::FindCorners(cell.Shape) : nullptr;
  if (corners)
  {
    this->AddHexahedron(number, cell, *corners);
  }
  else if (isWhole && !cell.Shape)
  {
    this->AddTetrahedron(number, cell);
  }
  else
  {
    this->VisitPixels(number, [&](Pixel& pixel) { this->AddOther(number, pixel); });
  }
}

void ScalarTile::AddTetrahedron(int number, const VolumeCells::Cell& cell)
{
  const VolumeCells& cells = this->Crossing.GetCells();
  const TetrahedronPlanes planes(cells.GetTetrahedron(cell));
  const size_t component = static_cast<size_t>(this->Integral.GetComponent());
  dvec4 scalars;
  for (int i = 0; i < 4; ++i)
  {
    scalars[i] = cell.Scalars >= 0 ? cells.GetCellScalars()[cell.Scalars][component]
                                   : this->GetScalar(cells.GetCornerId(cell, i));
  }
  const double margin = this->Crossing.GetShortest();
  this->VisitPixels(number,
    [&](Pixel& pixel)
    {
      TetrahedronCrossing crossing;
      if (planes.Cross(pixel.Way, margin, crossing))
      {
        const bool isConstant = cell.Scalars >= 0;
        pixel.Add(crossing.Begin, crossing.End,
          isConstant ? scalars[0] : dot(crossing.FrontWeights, scalars),
          isConstant ? scalars[0] : dot(crossing.BackWeights, scalars), number);
      }
    });
}

void ScalarTile::AddHexahedron(
  int number, const VolumeCells::Cell& cell, const HexahedronCrossing::Corners& corners)
{
  const VolumeCells& cells = this->Crossing.GetCells();
  HexahedronCrossing crossing;
  std::array<double, HexahedronCrossing::NumberOfCorners> scalars = {};
  for (int i = 0; i < HexahedronCrossing::NumberOfCorners; ++i)
  {
    const vtkIdType id = cells.GetCornerId(cell, corners[static_cast<size_t>(i)]);
    crossing.SetCorner(i, cells.GetPoints()[static_cast<size_t>(id)]);
    if (cell.Scalars < 0)
    {
      scalars[static_cast<size_t>(i)] = this->GetScalar(id);
    }
  }
  const auto range = std::minmax_element(scalars.begin(), scalars.end());
  const double size = std::max(std::abs(*range.first), std::abs(*range.second));
  const double tolerance = std::max(ScalarTolerance * (*range.second - *range.first) + 1e-12 * size,
    ColorTolerance / this->Integral.GetLargestSlope());
  const double shortest = this->Crossing.GetShortest();
  this->VisitPixels(number,
    [&](Pixel& pixel)
    {
      const auto result = crossing.Cross(pixel.Way, pixel.Across, shortest);
      if (result == HexahedronCrossing::Result::Missed)
      {
        return;
      }
      if (result == HexahedronCrossing::Result::Crossed && cell.Scalars >= 0)
      {
        const double scalar = cells.GetCellScalars()[static_cast<size_t>(
          cell.Scalars)][static_cast<size_t>(this->Integral.GetComponent())];
        pixel.Add(crossing.GetBegin(), crossing.GetEnd(), scalar, scalar, number);
        return;
      }
      if (result == HexahedronCrossing::Result::Unclear ||
        !this->AddCurve(crossing, scalars, tolerance, number, pixel))
      {
        this->AddOther(number, pixel);
      }
    });
}

// Returns false if the scalars are not a cubic.
bool ScalarTile::AddCurve(HexahedronCrossing& crossing,
  const std::array<double, HexahedronCrossing::NumberOfCorners>& scalars, double tolerance,
  int number, Pixel& pixel)
{
  std::array<dvec3, 4> parameters;
  if (!crossing.FindParameters(parameters))
  {
    return false;
  }
  std::array<double, 4> values;
  for (size_t i = 0; i < values.size(); ++i)
  {
    values[i] = HexahedronCrossing::Interpolate(scalars, parameters[i]);
  }
  const Cubic cubic(values);
  const double begin = crossing.GetBegin();
  const double length = crossing.GetEnd() - begin;
  if (!AreStraight(parameters))
  {
    dvec3 middle = 0.5 * (parameters[1] + parameters[2]);
    // The error at the middle is about half of the largest one.
    if (!crossing.Locate(begin + 0.5 * length, middle) ||
      std::abs(HexahedronCrossing::Interpolate(scalars, middle) - cubic.Evaluate(0.5)) >
        0.25 * tolerance)
    {
      return false;
    }
  }
  const int count = cubic.CountSegments(tolerance);
  double front = values[0];
  for (int i = 0; i < count; ++i)
  {
    const double first = static_cast<double>(i) / count;
    const double last = static_cast<double>(i + 1) / count;
    const double back = i + 1 == count ? values[3] : cubic.Evaluate(last);
    // The mean of a cubic according to Simpson's rule.
    const double lift = (cubic.Evaluate(0.5 * (first + last)) - 0.5 * (front + back)) * (2.0 / 3.0);
    pixel.Add(begin + first * length, begin + last * length, front + lift, back + lift, number);
    front = back;
  }
  return true;
}

void ScalarTile::AddOther(int number, Pixel& pixel)
{
  this->Others.clear();
  this->Crossing.AppendParts(static_cast<size_t>(number), pixel.Way, this->Others);
  const size_t component = static_cast<size_t>(this->Integral.GetComponent());
  for (const RayPart& part : this->Others)
  {
    pixel.Add(part.Begin, part.End, part.Front[component], part.Back[component], number);
  }
}

// Cells of a tile come nearly from front to back, so that insertion is fast.
void ScalarTile::Sort(std::vector<Part>& parts)
{
  size_t moves = MostMoves * parts.size();
  for (size_t i = 1; i < parts.size(); ++i)
  {
    if (!(parts[i] < parts[i - 1]))
    {
      continue;
    }
    const Part part = parts[i];
    size_t to = i;
    for (; to > 0 && part < parts[to - 1]; --to)
    {
      parts[to] = parts[to - 1];
    }
    parts[to] = part;
    if (moves < i - to)
    {
      std::sort(parts.begin(), parts.end());
      return;
    }
    moves -= i - to;
  }
}

// Overlaps are counted once.
dvec4 ScalarTile::Blend(Pixel& pixel) const
{
  Sort(pixel.Parts);
  CurveIntegral::State state;
  double reached = 0.0;
  for (const Part& part : pixel.Parts)
  {
    if (!(part.End > reached))
    {
      continue;
    }
    const double begin = std::max(part.Begin, reached);
    const double hidden = (begin - part.Begin) / (part.End - part.Begin);
    const double front = hidden > 0.0 ? mix(part.Front, part.Back, hidden) : part.Front;
    reached = part.End;
    if (this->IsAdditive)
    {
      this->Integral.Add(front, part.Back, part.End - begin, state);
      continue;
    }
    this->Integral.Composite(front, part.Back, part.End - begin, state);
    if (state.Seen.w > OpaqueAlpha)
    {
      break;
    }
  }
  return this->IsAdditive ? min(state.Seen, dvec4(1.0)) : state.Seen;
}
}
