// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   pictures to drape over a terrain
 */
#ifndef TerrainColours_h
#define TerrainColours_h

#include "vtkSmartPointer.h"

class vtkHeightField;
class vtkImageData;

/**
 * Colours over the range of heights, in the manner of relief maps: green lowlands to white summits.
 */
vtkSmartPointer<vtkImageData> MakeHypsometricTint(vtkHeightField* heights);

/**
 * Each band from its darkest to its 98th percentile, as raw satellite bands are usually shown. The
 * terrain source's grey, where the imagery does not reach, stays.
 */
vtkSmartPointer<vtkImageData> StretchContrast(vtkImageData* image);

#endif
