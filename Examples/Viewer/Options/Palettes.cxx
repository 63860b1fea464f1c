// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/Palettes.h"

#include "vtkColorTransferFunction.h"

#include <map>

namespace
{
using Palette = std::vector<std::array<double, 3>>; // evenly spaced

const std::map<std::string, Palette>& GetPalettes()
{
  static const std::map<std::string, Palette> palettes = {
    { "cool-warm", { { 0.23, 0.30, 0.75 }, { 0.87, 0.87, 0.87 }, { 0.71, 0.02, 0.15 } } },
    { "cyclic",
      { { 0.87, 0.38, 0.36 }, { 0.86, 0.70, 0.30 }, { 0.50, 0.74, 0.36 }, { 0.27, 0.71, 0.70 },
        { 0.36, 0.50, 0.83 }, { 0.69, 0.43, 0.74 }, { 0.87, 0.38, 0.36 } } },
    { "grey", { { 0.10, 0.10, 0.10 }, { 0.98, 0.98, 0.98 } } },
    { "heat",
      { { 1.00, 1.00, 0.80 }, { 1.00, 0.85, 0.46 }, { 0.99, 0.55, 0.24 }, { 0.89, 0.10, 0.11 },
        { 0.50, 0.00, 0.15 } } },
    { "magma",
      { { 0.00, 0.00, 0.01 }, { 0.32, 0.07, 0.49 }, { 0.72, 0.21, 0.48 }, { 0.99, 0.54, 0.38 },
        { 0.99, 0.99, 0.75 } } },
    { "rainbow",
      { { 0.00, 0.00, 1.00 }, { 0.00, 1.00, 1.00 }, { 0.00, 1.00, 0.00 }, { 1.00, 1.00, 0.00 },
        { 1.00, 0.00, 0.00 } } },
    { "relief",
      { { 0.27, 0.47, 0.29 }, { 0.53, 0.64, 0.39 }, { 0.83, 0.79, 0.55 }, { 0.70, 0.55, 0.37 },
        { 0.58, 0.49, 0.44 }, { 0.97, 0.97, 0.97 } } },
    { "viridis",
      { { 0.27, 0.01, 0.33 }, { 0.23, 0.32, 0.55 }, { 0.13, 0.57, 0.55 }, { 0.37, 0.79, 0.38 },
        { 0.99, 0.91, 0.14 } } },
    { "water",
      { { 0.05, 0.13, 0.33 }, { 0.11, 0.29, 0.55 }, { 0.26, 0.50, 0.73 }, { 0.62, 0.80, 0.90 } } },
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
  const std::string& name, const std::array<double, 2>& range)
{
  const Palette& colours = GetPalettes().at(name);
  // A plain gets the lowest colour.
  const double extent = range[1] > range[0] ? range[1] - range[0] : 1.0;
  auto table = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    table->AddRGBPoint(
      range[0] + extent * i / (colours.size() - 1), colours[i][0], colours[i][1], colours[i][2]);
  }
  return table;
}
