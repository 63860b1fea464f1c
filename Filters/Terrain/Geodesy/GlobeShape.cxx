// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/GlobeShape.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double DegreesPerRadian = 180.0 / 3.14159265358979323846;

// Bounds come from derivatives at nodes and are a little larger.
constexpr double BoundsMargin = 1.05;

// Rasters are closed if they end within this part of a sample.
constexpr double ClosingTolerance = 0.1;

constexpr double PositionsPerSample = 64.0;
constexpr std::size_t MaximumPositions = std::size_t(1) << 18;

// Places at the corners, sides and centre of a square, row by row.
constexpr int PlacesAround = 9;

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Combine(double s, const Vector& a, double t, const Vector& b)
{
  return { { s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2] } };
}
}

void GlobeShape::Bounds::Extend(const Bounds& other)
{
  // Positions outside of the projection are NaN and do not count.
  const auto extend = [](auto& values, const auto& others)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = others[i] > values[i] ? others[i] : values[i];
    }
  };
  extend(this->Lengths, other.Lengths);
  extend(this->Vertical, other.Vertical);
  extend(this->Horizontal, other.Horizontal);
}

// The variance of a coordinate in an interval is at most a quarter of its length squared.
double GlobeShape::Bounds::GetDistance(const std::array<double, 2>& size, double slope) const
{
  const double weights[3] = { size[0] * size[0], 2.0 * size[0] * size[1], size[1] * size[1] };
  double distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    distance += weights[i] * (this->Vertical[i] + slope * this->Horizontal[i]);
  }
  return distance / 8.0;
}

GlobeShape::GlobeShape(const Georeference& location, int width, int height)
  : Frame(location)
  , Geoid(location.WKT)
  , Size{ { width, height } }
  , Dimensions(Size)
  , End{ { width - 1.0, height - 1.0 } }
{
  const auto locate = [&](double column, double row)
  {
    const double u = (column + 0.5) / width;
    const double v = (row + 0.5) / height;
    return location.Coordinates(
      location.FlipColumns ? 1.0 - u : u, location.FlipRows ? 1.0 - v : v);
  };
  this->Origin = locate(0.0, 0.0);
  const std::array<double, 2> column = locate(width, 0.0);
  const std::array<double, 2> row = locate(0.0, height);
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Column[axis] = (column[axis] - this->Origin[axis]) / width;
    this->Row[axis] = (row[axis] - this->Origin[axis]) / height;
  }
  if (!this->Frame.GetError().empty())
  {
    return;
  }
  if (this->Frame.IsGeographic() && this->Column[1] == 0.0 && this->Row[0] == 0.0)
  {
    this->Close();
  }
  this->BuildBounds();
}

void GlobeShape::Close()
{
  double steps[2] = { this->Column[0], this->Row[1] };
  double origins[2] = { this->Origin[0], this->Origin[1] };
  this->Frame.ToAngles(1, &steps[0], &steps[1]);
  this->Frame.ToAngles(1, &origins[0], &origins[1]);
  if (std::abs(this->Size[0] * std::abs(steps[0]) - 360.0) <= ClosingTolerance * std::abs(steps[0]))
  {
    this->Period = this->Size[0];
    this->Dimensions[0] = this->Period + 2;
    this->End[0] = this->Period + 1.0;
  }
  const auto isPole = [&steps, &origins](double row)
  {
    const double latitude = origins[1] + row * steps[1];
    return std::abs(std::abs(latitude) - 90.0) <= ClosingTolerance * std::abs(steps[1]);
  };
  this->PoleCosine = std::max(this->PoleCosine, std::sin(std::abs(steps[1]) / DegreesPerRadian));
  if (isPole(-0.5))
  {
    this->FirstRowShift = -0.5;
  }
  if (isPole(this->Size[1] - 0.5))
  {
    this->Dimensions[1] = this->Size[1] + 1;
    this->End[1] = this->Size[1];
  }
  this->FirstPole = this->FirstRowShift != 0.0 || isPole(0.0);
  this->LastPole = this->Dimensions[1] > this->Size[1] || isPole(this->End[1]);
}

// In place.
void GlobeShape::ToAngles(std::size_t number, double* columns, double* rows, bool isClosed) const
{
  for (std::size_t i = 0; i < number; ++i)
  {
    // The same bits on both sides of the seam.
    const double column =
      isClosed && columns[i] >= this->Period ? columns[i] - this->Period : columns[i];
    double row = rows[i];
    if (isClosed && row < 1.0)
    {
      row += this->FirstRowShift * (1.0 - row);
    }
    else if (isClosed && this->LastPole && row > this->Size[1] - 1.0)
    {
      // The pole is at the end, and everything beyond it is, too.
      const double last = this->Size[1] - 1.0;
      row = last + 0.5 * (std::min(row, this->End[1]) - last);
    }
    columns[i] = this->Origin[0] + column * this->Column[0] + row * this->Row[0];
    rows[i] = this->Origin[1] + column * this->Column[1] + row * this->Row[1];
  }
  this->Frame.ToAngles(number, columns, rows);
}

Vector GlobeShape::GetPosition(double column, double row) const
{
  const auto compute = [this](double x, double y)
  {
    this->ToAngles(1, &x, &y, true);
    return this->Frame.GetPlace(x, y).Position;
  };
  if (this->Frame.IsGeographic())
  {
    return compute(column, row);
  }
  // Most are centres of blocks and their regions.
  const double x = column * PositionsPerSample;
  const double y = row * PositionsPerSample;
  if (x != std::floor(x) || y != std::floor(y) || x < 0.0 || y < 0.0)
  {
    return compute(column, row);
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const std::uint64_t key = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x);
  const auto known = this->Positions.find(key);
  if (known != this->Positions.end())
  {
    return known->second;
  }
  if (this->Positions.size() >= MaximumPositions)
  {
    this->Positions.clear();
  }
  return this->Positions.emplace(key, compute(column, row)).first->second;
}

void GlobeShape::Locate(
  std::size_t number, const double* columns, const double* rows, Vertex* vertices) const
{
  std::vector<double> x(columns, columns + number);
  std::vector<double> y(rows, rows + number);
  this->ToAngles(number, x.data(), y.data(), true);
  // Columns and rows per degree.
  std::array<double, 4> perDegree{};
  if (this->Frame.IsGeographic())
  {
    double steps[4] = { this->Column[0], this->Row[0], this->Column[1], this->Row[1] };
    this->Frame.ToAngles(2, steps, steps + 2);
    const double determinant = steps[0] * steps[3] - steps[1] * steps[2];
    perDegree = { { steps[3] / determinant, -steps[2] / determinant, -steps[1] / determinant,
      steps[0] / determinant } };
  }
  for (std::size_t i = 0; i < number; ++i)
  {
    Vertex& vertex = vertices[i];
    const GeocentricFrame::Place place = this->Frame.GetPlace(x[i], y[i]);
    vertex.Position = place.Position;
    vertex.Up = place.Up;
    vertex.Geoid = std::isnan(y[i]) ? 0.0 : this->Geoid.Get(x[i], y[i]);
    if (std::isnan(place.Position[0]))
    {
      vertex.Derivatives = {};
      this->Extrapolate(columns[i], rows[i], vertex);
      continue;
    }
    if (this->Frame.IsGeographic())
    {
      const std::array<double, 2> radii = this->Frame.GetRadii(y[i]);
      const double east = DegreesPerRadian / radii[0];
      const double north = DegreesPerRadian / radii[1];
      vertex.Derivatives = { { static_cast<float>(perDegree[0] * east),
        static_cast<float>(perDegree[1] * east), static_cast<float>(perDegree[2] * north),
        static_cast<float>(perDegree[3] * north) } };
      continue;
    }
    const double u = std::clamp(columns[i] / this->End[0], 0.0, 1.0) * Cells;
    const double v = std::clamp(rows[i] / this->End[1], 0.0, 1.0) * Cells;
    const int first[2] = { std::min(static_cast<int>(u), Cells - 1),
      std::min(static_cast<int>(v), Cells - 1) };
    const double weights[2] = { u - first[0], v - first[1] };
    std::array<double, 6> gradient{};
    for (int corner = 0; corner < 4; ++corner)
    {
      const double weight = (corner % 2 == 0 ? 1.0 - weights[0] : weights[0]) *
        (corner / 2 == 0 ? 1.0 - weights[1] : weights[1]);
      const std::array<double, 6>& node =
        this->Gradients[(first[1] + corner / 2) * (Cells + 1) + first[0] + corner % 2];
      for (int c = 0; c < 6; ++c)
      {
        gradient[c] += weight * node[c];
      }
    }
    const Vector east = { { -place.Up[1], place.Up[0], 0.0 } };
    const double cosine = std::hypot(east[0], east[1]);
    const double inverse = cosine > 0.0 ? 1.0 / cosine : 0.0; // there is no north at a pole
    const Vector north = { { -place.Up[2] * place.Up[0] * inverse,
      -place.Up[2] * place.Up[1] * inverse, cosine } };
    for (int by = 0; by < 2; ++by)
    {
      const Vector of = { { gradient[3 * by], gradient[3 * by + 1], gradient[3 * by + 2] } };
      vertex.Derivatives[by] = static_cast<float>(Dot(of, east));
      vertex.Derivatives[2 + by] = static_cast<float>(Dot(of, north));
    }
  }
}

void GlobeShape::Extrapolate(double column, double row, Vertex& vertex) const
{
  const double inside[2] = { std::min(column, this->End[0]), std::min(row, this->End[1]) };
  if (inside[0] == column && inside[1] == row)
  {
    return;
  }
  double columns[2] = { inside[0], 2.0 * inside[0] - column };
  double rows[2] = { inside[1], 2.0 * inside[1] - row };
  this->ToAngles(2, columns, rows, true);
  const GeocentricFrame::Place place = this->Frame.GetPlace(columns[0], rows[0]);
  const Vector mirrored = this->Frame.GetPlace(columns[1], rows[1]).Position;
  vertex.Position = Combine(2.0, place.Position, -1.0, mirrored);
  vertex.Up = place.Up;
}

// Differences of the places around a node give the derivatives there.
GlobeShape::Bounds GlobeShape::BuildNode(
  const double* x, const double* y, const std::array<double, 2>& step)
{
  std::array<GeocentricFrame::Place, PlacesAround> places;
  for (int i = 0; i < PlacesAround; ++i)
  {
    places[i] = this->Frame.GetPlace(x[i], y[i]);
  }
  const auto difference = [&](int after, int before, double length)
  { return Combine(1.0 / length, places[after].Position, -1.0 / length, places[before].Position); };
  const auto second = [&](int after, int before, double length)
  {
    const Vector sum = Combine(1.0, places[after].Position, 1.0, places[before].Position);
    return Combine(1.0 / (length * length), sum, -2.0 / (length * length), places[4].Position);
  };
  const Vector column = difference(5, 3, 2.0 * step[0]);
  const Vector row = difference(7, 1, 2.0 * step[1]);
  const double scale = 0.25 / (step[0] * step[1]);
  const Vector twist = Combine(scale, Combine(1.0, places[8].Position, 1.0, places[0].Position),
    -scale, Combine(1.0, places[6].Position, 1.0, places[2].Position));
  const Vector seconds[3] = { second(5, 3, step[0]), twist, second(7, 1, step[1]) };
  Bounds bounds;
  bounds.Lengths = { { BoundsMargin * std::sqrt(Dot(column, column)),
    BoundsMargin * std::sqrt(Dot(row, row)) } };
  for (int i = 0; i < 3; ++i)
  {
    const double vertical = Dot(seconds[i], places[4].Up);
    bounds.Vertical[i] = BoundsMargin * std::abs(vertical);
    bounds.Horizontal[i] =
      BoundsMargin * std::sqrt(std::max(0.0, Dot(seconds[i], seconds[i]) - vertical * vertical));
  }
  // The dual basis of the tangent plane.
  const double a = Dot(column, column);
  const double b = Dot(column, row);
  const double c = Dot(row, row);
  const double determinant = a * c - b * b;
  const Vector dual[2] = { Combine(c / determinant, column, -b / determinant, row),
    Combine(-b / determinant, column, a / determinant, row) };
  this->Gradients.push_back(
    { { dual[0][0], dual[0][1], dual[0][2], dual[1][0], dual[1][1], dual[1][2] } });
  this->Nodes.push_back(places[4]);
  return bounds;
}

void GlobeShape::BuildBounds()
{
  constexpr int nodes = Cells + 1;
  const std::array<double, 2> cell = { { this->End[0] / Cells, this->End[1] / Cells } };
  const std::array<double, 2> step = { { std::max(1.0, cell[0] / 8.0),
    std::max(1.0, cell[1] / 8.0) } };
  std::vector<double> x;
  std::vector<double> y;
  for (int node = 0; node < nodes * nodes; ++node)
  {
    for (int i = 0; i < PlacesAround; ++i)
    {
      x.push_back(cell[0] * (node % nodes) + step[0] * (i % 3 - 1));
      y.push_back(cell[1] * (node / nodes) + step[1] * (i / 3 - 1));
    }
  }
  this->ToAngles(x.size(), x.data(), y.data(), false);
  std::vector<Bounds> atNodes;
  for (int first = 0; first < PlacesAround * nodes * nodes; first += PlacesAround)
  {
    atNodes.push_back(this->BuildNode(&x[first], &y[first], step));
  }
  std::vector<Bounds> finest(Cells * Cells);
  for (int i = 0; i < Cells * Cells; ++i)
  {
    const int node = i / Cells * nodes + i % Cells;
    for (int corner : { node, node + 1, node + nodes, node + nodes + 1 })
    {
      finest[i].Extend(atNodes[corner]);
    }
    if (i < Cells && this->FirstRowShift != 0.0)
    {
      finest[i].Lengths[1] *= 1.0 - this->FirstRowShift;
    }
    this->NodeDistance = std::max(this->NodeDistance, finest[i].GetDistance(cell));
  }
  this->Levels.push_back(std::move(finest));
  for (int cells = Cells / 2; cells > 0; cells /= 2)
  {
    std::vector<Bounds> coarser(cells * cells);
    for (int i = 0; i < 4 * cells * cells; ++i)
    {
      coarser[i / (2 * cells) / 2 * cells + i % (2 * cells) / 2].Extend(this->Levels.back()[i]);
    }
    this->Levels.push_back(std::move(coarser));
  }
}

GlobeShape::Bounds GlobeShape::GetBounds(
  const std::array<double, 2>& columns, const std::array<double, 2>& rows) const
{
  const std::array<double, 2>* ranges[2] = { &columns, &rows };
  const auto toCell = [this](double position, int axis)
  { return std::clamp(position / this->End[axis], 0.0, 1.0) * Cells; };
  std::size_t level = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double cells = ((*ranges[axis])[1] - (*ranges[axis])[0]) / this->End[axis] * Cells;
    while (level + 1 < this->Levels.size() && cells > std::ldexp(1.0, static_cast<int>(level)))
    {
      ++level;
    }
  }
  const int last = (Cells >> level) - 1;
  int first[2];
  int end[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto find = [&](double position)
    { return std::min(static_cast<int>(toCell(position, axis)) >> level, last); };
    first[axis] = find((*ranges[axis])[0]);
    end[axis] = find((*ranges[axis])[1]);
  }
  Bounds bounds;
  for (int row = first[1]; row <= end[1]; ++row)
  {
    for (int column = first[0]; column <= end[0]; ++column)
    {
      bounds.Extend(this->Levels[level][row * (last + 1) + column]);
    }
  }
  return bounds;
}
}
