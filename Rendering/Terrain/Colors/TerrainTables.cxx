// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Colors/TerrainTables.h"

#include "Buffers/ColorTable.h"
#include "vtkLookupTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
using EvenColors = std::vector<std::array<double, 3>>; // evenly spaced

constexpr int ColorsOfTable = 256;
constexpr int JoinedColors = 4096; // on the longer side of the sea level

void Interpolate(const EvenColors& colors, vtkLookupTable* table)
{
  table->SetNumberOfTableValues(ColorsOfTable);
  for (int i = 0; i < ColorsOfTable; ++i)
  {
    const double place = i * (colors.size() - 1.0) / (ColorsOfTable - 1.0);
    const auto first = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const double t = place - static_cast<double>(first);
    std::array<double, 3> color;
    for (int c = 0; c < 3; ++c)
    {
      color[c] = colors[first][c] + t * (colors[first + 1][c] - colors[first][c]);
    }
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
}
}

void SetHues(vtkLookupTable* table, bool isCyclic)
{
  table->SetNumberOfTableValues(ColorsOfTable);
  table->SetHueRange(isCyclic ? 0.0 : 2.0 / 3.0, isCyclic ? 1.0 : 0.0);
  table->ForceBuild();
}

void SetColorsOfLand(vtkLookupTable* table)
{
  Interpolate({ { { 0.27, 0.47, 0.29 } }, { { 0.53, 0.64, 0.39 } }, { { 0.83, 0.79, 0.55 } },
                { { 0.70, 0.55, 0.37 } }, { { 0.58, 0.49, 0.44 } }, { { 0.97, 0.97, 0.97 } } },
    table);
}

void SetColorsOfWater(vtkLookupTable* table)
{
  Interpolate({ { { 0.05, 0.13, 0.33 } }, { { 0.11, 0.29, 0.55 } }, { { 0.26, 0.50, 0.73 } },
                { { 0.62, 0.80, 0.90 } } },
    table);
}

void SetGreys(vtkLookupTable* table)
{
  Interpolate({ { { 0.0, 0.0, 0.0 } }, { { 1.0, 1.0, 1.0 } } }, table);
}

void JoinAtSeaLevel(
  vtkScalarsToColors* water, vtkScalarsToColors* land, double seaLevel, vtkLookupTable* joined)
{
  const double below = std::max(seaLevel - water->GetRange()[0], 0.0);
  const double above = std::max(land->GetRange()[1] - seaLevel, 0.0);
  const double longer = std::max(below, above);
  const double shorter = std::min(below, above);
  double step = (longer > 0.0 ? longer : 1.0) / JoinedColors;
  if (shorter >= step)
  {
    step = shorter / std::ceil(shorter / step); // ends where its table ends
  }
  const auto count = [step](double length)
  { return std::max(static_cast<int>(std::ceil(length / step - 1e-6)), 1); };
  const int first = count(below); // of the land
  const int colors = first + count(above);
  const double border = seaLevel + 0.01 * step;
  joined->SetNumberOfTableValues(colors);
  joined->SetTableRange(border - first * step, border + (colors - first) * step);
  for (int i = 0; i < colors; ++i)
  {
    const double value = border + (i - first + 0.5) * step;
    const std::array<float, 4> color =
      ColorTable::GetColor(i < first ? water : land, std::min(value, land->GetRange()[1]));
    joined->SetTableValue(i, color[0], color[1], color[2], color[3]);
  }
}
}
