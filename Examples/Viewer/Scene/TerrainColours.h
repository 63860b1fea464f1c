// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   colours by height, and pictures to drape over a terrain
 */
#ifndef TerrainColours_h
#define TerrainColours_h

#include "vtkSmartPointer.h"

class vtkHeightField;
class vtkImageData;
class vtkScalarsToColors;

/// A picture of a terrain, coloured by height.
vtkSmartPointer<vtkImageData> MakeHypsometricTint(
  vtkHeightField* heights, vtkScalarsToColors* colours);

/**
 * Stretches each band from its minimum to its 98th percentile, as is usual for raw satellite bands.
 * Keeps the grey that the terrain source uses outside the imagery.
 */
vtkSmartPointer<vtkImageData> StretchContrast(vtkImageData* image);

#endif
