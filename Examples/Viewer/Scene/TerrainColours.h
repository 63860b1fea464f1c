// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   colours by height, and pictures to drape over a terrain
 */
#ifndef TerrainColours_h
#define TerrainColours_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkHeightField;
class vtkImageData;
class vtkScalarsToColors;

/// The names of palettes, sorted.
std::vector<std::string> GetPaletteNames();

/// The colours of a palette over a range of values. Heights have "relief" by default: green
/// lowlands to white summits.
vtkSmartPointer<vtkColorTransferFunction> MakePalette(
  const std::string& name, const std::array<double, 2>& range);

/// A picture of a terrain, coloured by height.
vtkSmartPointer<vtkImageData> MakeHypsometricTint(
  vtkHeightField* heights, vtkScalarsToColors* colours);

/**
 * Stretches each band from its minimum to its 98th percentile, as is usual for raw satellite bands.
 * Keeps the grey that the terrain source uses outside the imagery.
 */
vtkSmartPointer<vtkImageData> StretchContrast(vtkImageData* image);

#endif
