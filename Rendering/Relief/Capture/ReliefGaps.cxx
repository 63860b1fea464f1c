// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/ReliefGaps.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr int SampleStep = 4;

double GetArea(const dvec2& a, const dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}
}

GapMap::GapMap(int width, int height)
  : Width(width)
  , Height(height)
  , Shown(
      static_cast<size_t>((width + CellSize - 1) / CellSize) * ((height + CellSize - 1) / CellSize),
      0.0)
  , Open(this->Shown)
  , TexelWidth(std::numeric_limits<double>::infinity())
{
}

bool GapMap::Contains(const dvec2& pixel) const
{
  return pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < this->Width && pixel.y < this->Height;
}

void GapMap::Add(std::vector<double>& areas, const dvec2& pixel, double area) const
{
  if (this->Contains(pixel))
  {
    const int column = static_cast<int>(pixel.x) / CellSize;
    const int row = static_cast<int>(pixel.y) / CellSize;
    areas[static_cast<size_t>(row) * ((this->Width + CellSize - 1) / CellSize) + column] += area;
  }
}

// Projects texels to the pixels of a view.
class ReliefGaps::View
{
public:
  View(const dmat4& texelToClip, GapMap& map)
    : TexelToClip(texelToClip)
    , Map(map)
  {
  }

  bool IsInFront(const Texel& texel) const { return this->GetClip(texel, 0.0, 0.0).w > 0.0; }

  dvec2 Project(const Texel& texel, double right = 0.0, double up = 0.0) const
  {
    const dvec4 clip = this->GetClip(texel, right, up);
    return (dvec2(clip) / clip.w * 0.5 + 0.5) * dvec2(this->Map.Width, this->Map.Height);
  }

  void AddSample(const Texel& texel)
  {
    if (this->IsInFront(texel))
    {
      const dvec2 place = this->Project(texel);
      const double area =
        GetArea(this->Project(texel, 1.0) - place, this->Project(texel, 0.0, 1.0) - place);
      this->Map.AddShown(place, SampleStep * SampleStep * std::abs(area));
      if (this->Map.Contains(place))
      {
        this->Areas.push_back(std::abs(area));
      }
    }
  }

  void FindTexelWidth()
  {
    if (!this->Areas.empty())
    {
      const auto middle = this->Areas.begin() + this->Areas.size() / 2;
      std::nth_element(this->Areas.begin(), middle, this->Areas.end());
      this->Map.TexelWidth = std::sqrt(*middle);
    }
  }

  // Add the area that opens between the two sides, without the texel that was there.
  void AddPair(const Pair& pair)
  {
    if (!this->IsInFront(pair.First) || !this->IsInFront(pair.Second))
    {
      return;
    }
    const dvec2 first = this->Project(pair.First);
    const dvec2 apart = this->Project(pair.Second) - first;
    const dvec2 right = this->Project(pair.First, 1.0) - first;
    const dvec2 up = this->Project(pair.First, 0.0, 1.0) - first;
    const double texel = GetArea(right, up);
    const double swept = pair.IsUpwards ? GetArea(right, apart) : GetArea(apart, up);
    const double area = texel > 0.0 ? swept - texel : texel - swept;
    if (area > 0.0)
    {
      this->Spread(first, apart, area);
    }
  }

  // Treat everything between the border of the relief and that of the view as open.
  void AddSide(const Texel& texel, const dvec2& outwards)
  {
    if (!this->IsInFront(texel))
    {
      return;
    }
    const dvec2 place = this->Project(texel);
    const dvec2 step = this->Project(texel, outwards.x, outwards.y) - place;
    const dvec2 along = this->Project(texel, outwards.y, outwards.x) - place;
    const double size = length(step);
    const double steps = this->CountSteps(place, step);
    if (steps > 0.0 && size > 0.0)
    {
      this->Spread(place, steps * step, steps * std::abs(GetArea(step, along)));
    }
  }

private:
  dvec4 GetClip(const Texel& texel, double right, double up) const
  {
    return this->TexelToClip * dvec4(texel.Column + right, texel.Row + up, texel.Height, 1.0);
  }

  // Return the number of steps to the border of the view; 0 from outside.
  double CountSteps(const dvec2& place, const dvec2& step) const
  {
    double steps = std::numeric_limits<double>::infinity();
    const dvec2 size(this->Map.Width, this->Map.Height);
    for (int i = 0; i < 2; ++i)
    {
      const double room = step[i] > 0.0 ? size[i] - place[i] : place[i];
      steps = step[i] == 0.0 ? steps : std::min(steps, room / std::abs(step[i]));
      steps = place[i] < 0.0 || place[i] > size[i] ? 0.0 : steps;
    }
    return std::isfinite(steps) ? std::max(steps, 0.0) : 0.0;
  }

  void Spread(const dvec2& place, const dvec2& way, double area)
  {
    const double cells = length(way) / GapMap::CellSize;
    const int parts = static_cast<int>(std::min(std::max(std::ceil(cells), 1.0), 4096.0));
    for (int i = 0; i < parts; ++i)
    {
      this->Map.AddOpen(place + (i + 0.5) / parts * way, area / parts);
    }
  }

  const dmat4 TexelToClip;
  GapMap& Map;
  std::vector<double> Areas; // areas of the shown texels
};

ReliefGaps::ReliefGaps(const Relief& relief, const std::vector<unsigned char>& sides)
  : TexelToWorld(relief.GetTexelToWorld())
{
  const int width = relief.GetWidth();
  const int height = relief.GetHeight();
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const size_t at = static_cast<size_t>(row) * width + column;
      const float depth = relief.GetDepths()[at];
      if (!std::isfinite(depth))
      {
        continue;
      }
      if (row % SampleStep == 0 && column % SampleStep == 0)
      {
        this->Samples.push_back({ static_cast<float>(column), static_cast<float>(row),
          static_cast<float>(relief.ToHeight(depth)) });
      }
      if (column + 1 < width && !(sides[at] & RightSide))
      {
        this->AddPair(relief, column, row, false);
      }
      if (row + 1 < height && !(sides[at] & UpperSide))
      {
        this->AddPair(relief, column, row, true);
      }
    }
  }
  for (int row = 0; row < height; ++row)
  {
    this->AddBorder(relief, 0, row, -1, 0);
    this->AddBorder(relief, width - 1, row, 1, 0);
  }
  for (int column = 0; column < width; ++column)
  {
    this->AddBorder(relief, column, 0, 0, -1);
    this->AddBorder(relief, column, height - 1, 0, 1);
  }
}

void ReliefGaps::AddPair(const Relief& relief, int column, int row, bool isUpwards)
{
  const auto get = [&](int x, int y)
  {
    return Texel{ static_cast<float>(x), static_cast<float>(y),
      static_cast<float>(relief.GetTexelHeight(x, y)) };
  };
  const Pair pair{ get(column, row), get(column + (isUpwards ? 0 : 1), row + (isUpwards ? 1 : 0)),
    isUpwards };
  if (std::isfinite(pair.Second.Height))
  {
    this->Pairs.push_back(pair);
  }
}

void ReliefGaps::AddBorder(const Relief& relief, int column, int row, int right, int up)
{
  const auto height = static_cast<float>(relief.GetTexelHeight(column, row));
  if (std::isfinite(height))
  {
    const Texel texel{ static_cast<float>(column), static_cast<float>(row), height };
    this->Sides.push_back({ texel, dvec2(right, up) });
  }
}

GapMap ReliefGaps::Find(const dmat4& worldToClip, int width, int height) const
{
  GapMap map(width, height);
  View view(worldToClip * this->TexelToWorld, map);
  for (const Texel& texel : this->Samples)
  {
    view.AddSample(texel);
  }
  view.FindTexelWidth();
  for (const Pair& pair : this->Pairs)
  {
    view.AddPair(pair);
  }
  for (const Side& side : this->Sides)
  {
    view.AddSide(side.From, side.Outwards);
  }
  return map;
}

double FindHoleShare(const std::vector<GapMap>& maps)
{
  double shown = 0.0;
  double open = 0.0;
  constexpr double whole = GapMap::CellSize * GapMap::CellSize;
  for (size_t cell = 0; !maps.empty() && cell < maps[0].Shown.size(); ++cell)
  {
    double least = whole;
    double most = 0.0;
    for (const GapMap& map : maps)
    {
      if (map.Shown[cell] > 0.0 || map.Open[cell] > 0.0)
      {
        least = std::min(least, map.Open[cell]);
        most = std::max(most, map.Shown[cell] + map.Open[cell]);
      }
    }
    shown += std::min(most, whole);
    open += most > 0.0 ? least : 0.0;
  }
  return shown > 0.0 ? std::min(open / shown, 1.0) : 0.0;
}
}
