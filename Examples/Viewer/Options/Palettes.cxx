// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/Palettes.h"

#include "vtkColorTransferFunction.h"

#include <cmath>
#include <map>

namespace
{
using Palette = std::vector<std::array<double, 3>>; // evenly spaced

const std::map<std::string, Palette>& GetPalettes()
{
  static const std::map<std::string, Palette> palettes = {
#include "Palettes.inc"
  };
  return palettes;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetPaletteNames()
{
  std::vector<std::string> names;
  for (const auto& palette : GetPalettes())
  {
    names.push_back(palette.first);
  }
  return names;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> MakePalette(
  const std::string& name, const std::array<double, 2>& range, bool isLogarithmic)
{
  const Palette& colours = GetPalettes().at(name);
  // A constant gets the lowest colour.
  const double constant = isLogarithmic ? 10.0 * range[0] : range[0] + 1.0;
  const double high = range[1] > range[0] ? range[1] : constant;
  auto table = vtkSmartPointer<vtkColorTransferFunction>::New();
  if (isLogarithmic)
  {
    table->SetScaleToLog10();
  }
  const std::size_t last = colours.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const double inner = isLogarithmic
      ? range[0] * std::pow(high / range[0], static_cast<double>(i) / last)
      : range[0] + (high - range[0]) * i / last;
    // The ends are exact, because colours of other values begin there.
    const double value = i == 0 ? range[0] : (i == last ? high : inner);
    table->AddRGBPoint(value, colours[i][0], colours[i][1], colours[i][2]);
  }
  return table;
}
