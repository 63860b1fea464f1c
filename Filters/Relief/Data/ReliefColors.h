// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the colours of reliefs: of other types, or of depths alone
 *
 * Private to the modules' own sources.
 */
#ifndef ReliefColors_h
#define ReliefColors_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataArray;
class vtkFloatArray;
class vtkUnsignedCharArray;

namespace relevo
{
/**
 * Colours of 1 to 4 components (grey, grey and opacity, RGB, RGBA) as 3 or 4 bytes each: unsigned
 * char as they are, unsigned short from 0 to 65535, float and double from 0 to 1. nullptr, and what
 * is wrong with them in `fault`, for others.
 */
vtkSmartPointer<vtkUnsignedCharArray> ConvertColors(vtkDataArray* colors, std::string& fault);

/// Grey: white is nearest, dark grey farthest, black where nothing was seen.
vtkSmartPointer<vtkUnsignedCharArray> MakeDepthColors(vtkFloatArray* depths);
}

#endif
