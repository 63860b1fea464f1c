// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the palettes that --palette names
 */
#ifndef Palettes_h
#define Palettes_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;

/// The names, sorted.
std::vector<std::string> GetPaletteNames();

/// The colours of a palette over a range of values. Heights have "relief" by default: green
/// lowlands to white summits. A logarithmic scale needs a range above 0.
vtkSmartPointer<vtkColorTransferFunction> MakePalette(
  const std::string& name, const std::array<double, 2>& range, bool isLogarithmic = false);

#endif
