// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PartCutter.h"

#include "Cells/CellKind.h"
#include "vtkImplicitFunction.h"
#include "vtkPlane.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr int MaximumIntervals = 128;
constexpr int MaximumSteps = 40;    // towards a root
constexpr double Converged = 1e-14; // share of the values at the ends

const PolyhedronFaces& GetFacesOfHexahedron()
{
  static const PolyhedronFaces faces = []
  {
    PolyhedronFaces all;
    for (int i = 0; i < 6; ++i)
    {
      const CornerNodes face = GetFace(CellTopology::Hexahedron, i);
      all.emplace_back(face.Corners.begin(), face.Corners.begin() + face.Size);
    }
    return all;
  }();
  return faces;
}
}

PartCutter::PartCutter(vtkImplicitFunction* function, double tolerance)
  : Function(function)
  , IsLinear(vtkPlane::SafeDownCast(function) && !function->GetTransform())
  , Tolerance(tolerance)
{
}

// In an interval h, linear interpolation differs by at most h^2 / 8 times the second derivative.
// The three directions add up.
void PartCutter::Cut(const BezierHexahedron& part, const std::array<bool, 6>& isOuter,
  const Weigher& weigh, CellSection& section)
{
  this->Part = &part;
  this->IsOuter = &isOuter;
  this->Weigh = &weigh;
  this->Section = &section;
  double deviation = 0.0;
  for (int direction = 0; direction < 3; ++direction)
  {
    deviation += part.BoundSecondDerivatives(direction)[0] / 8.0;
  }
  dvec3 at = part.GetPosition(dvec3(0.5));
  dvec3 slope;
  this->Function->FunctionGradient(&at.x, &slope.x);
  this->ValueDeviation = deviation * length(slope);
  this->Intervals = this->CountIntervals(deviation);
  this->Values.clear();
  this->Crossings.clear();
  this->Descend(ivec3(0), this->Intervals);
}

// A power of two.
int PartCutter::CountIntervals(double deviation) const
{
  int intervals = 1;
  while (intervals < this->MinimumIntervals ||
    (intervals < MaximumIntervals && deviation > this->Tolerance * intervals * intervals))
  {
    intervals *= 2;
  }
  return intervals;
}

double PartCutter::GetValue(const dvec3& parameters) const
{
  const dvec3 position = this->Part->GetPosition(parameters);
  return this->Function->FunctionValue(&position.x);
}

int PartCutter::GetSample(const ivec3& at) const
{
  const int size = this->Intervals + 1;
  return at.x + size * (at.y + size * at.z);
}

dvec3 PartCutter::GetParameters(int sample) const
{
  const int size = this->Intervals + 1;
  const ivec3 at(sample % size, sample / size % size, sample / size / size);
  return dvec3(at) / double(this->Intervals);
}

double PartCutter::GetSampleValue(int sample)
{
  const auto known = this->Values.find(sample);
  return known != this->Values.end()
    ? known->second
    : this->Values[sample] = this->GetValue(this->GetParameters(sample));
}

void PartCutter::Descend(const ivec3& low, int size)
{
  std::array<int, 8> samples;
  std::array<double, 2> range{};
  for (int k = 0; k < 8; ++k)
  {
    samples[k] = this->GetSample(low + size * GetCornerCoordinates(CellTopology::Hexahedron, k));
    const double value = this->GetSampleValue(samples[k]);
    range[0] = k == 0 ? value : std::min(range[0], value);
    range[1] = k == 0 ? value : std::max(range[1], value);
  }
  if (size == 1)
  {
    if (range[0] < 0.0 && range[1] >= 0.0)
    {
      this->CutPiece(low, samples);
    }
    return;
  }
  const double share = static_cast<double>(size) / this->Intervals;
  const double deviation = share * share * this->ValueDeviation;
  if (this->IsLinear && (range[0] - deviation > 0.0 || range[1] + deviation < 0.0))
  {
    return;
  }
  for (int k = 0; k < 8; ++k)
  {
    this->Descend(low + size / 2 * ivec3(k & 1, k >> 1 & 1, k >> 2 & 1), size / 2);
  }
}

void PartCutter::CutPiece(const ivec3& low, const std::array<int, 8>& samples)
{
  std::vector<double> values;
  for (const int sample : samples)
  {
    values.push_back(this->GetSampleValue(sample));
  }
  const PolyhedronSection cut = CutPolyhedron(GetFacesOfHexahedron(), values);
  std::vector<int> points;
  for (const std::array<int, 2>& edge : cut.Edges)
  {
    const std::array<int, 2> ends{ std::min(samples[edge[0]], samples[edge[1]]),
      std::max(samples[edge[0]], samples[edge[1]]) };
    const auto known = this->Crossings.find(ends);
    points.push_back(known != this->Crossings.end()
        ? known->second
        : this->Crossings[ends] = this->AddCrossing(ends));
  }
  std::vector<unsigned char> isOuter(6);
  for (int face = 0; face < 6; ++face)
  {
    const int border = face % 2 == 0 ? 0 : this->Intervals - 1;
    isOuter[face] = (*this->IsOuter)[face] && low[face / 2] == border;
  }
  this->Section->Add(cut, points, isOuter);
}

// The Illinois variant of regula falsi, so that the point is on the surface and in the cell.
int PartCutter::AddCrossing(const std::array<int, 2>& samples)
{
  const dvec3 from = this->GetParameters(samples[0]);
  const dvec3 to = this->GetParameters(samples[1]);
  std::array<double, 2> shares{ 0.0, 1.0 };
  std::array<double, 2> values{ this->GetSampleValue(samples[0]),
    this->GetSampleValue(samples[1]) };
  const bool isNegative = values[0] < 0.0;
  const double smallest = Converged * std::max(std::abs(values[0]), std::abs(values[1]));
  dvec3 place;
  int last = -1;
  for (int i = 0; i < MaximumSteps; ++i)
  {
    const double share = (shares[0] * values[1] - shares[1] * values[0]) / (values[1] - values[0]);
    place = mix(from, to, share);
    const double value = this->GetValue(place);
    if (std::abs(value) <= smallest)
    {
      break;
    }
    const int side = (value < 0.0) == isNegative ? 0 : 1;
    shares[side] = share;
    values[side] = value;
    if (side == last)
    {
      values[1 - side] *= 0.5;
    }
    last = side;
  }
  CellSection& section = *this->Section;
  section.Points.push_back(this->Part->GetPosition(place));
  const std::size_t before = section.Weights.size();
  section.Weights.resize(before + section.Nodes.size());
  (*this->Weigh)(place, &section.Weights[before]);
  section.Edges.push_back({ { -1, -1 } });
  return static_cast<int>(section.Points.size()) - 1;
}
}
