// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   colours of heights, and pictures to drape over a terrain
 */
#ifndef TerrainColours_h
#define TerrainColours_h

#include "vtkSmartPointer.h"

class vtkHeightField;
class vtkImageData;
class vtkScalarsToColors;

/// Colours over a range of heights, in the manner of relief maps: green lowlands to white summits.
vtkSmartPointer<vtkScalarsToColors> MakeHeightColours(const double range[2]);

/// The picture of a terrain in the colours of its heights.
vtkSmartPointer<vtkImageData> MakeHypsometricTint(
  vtkHeightField* heights, vtkScalarsToColors* colours);

/**
 * Each band from its darkest to its 98th percentile, as raw satellite bands are usually shown. The
 * terrain source's grey, where the imagery does not reach, stays.
 */
vtkSmartPointer<vtkImageData> StretchContrast(vtkImageData* image);

#endif
