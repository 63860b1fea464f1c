// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   colours from arrays that contain them
 */
#ifndef DirectColors_h
#define DirectColors_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <vector> // for return value

class vtkDataArray;

namespace relevo
{
/**
 * Return 4 floats for each tuple: luminance, luminance and alpha, RGB, or RGBA, as in
 * vtkScalarsToColors::ConvertToRGBA(). `type` is the type of the colours, if the values are their
 * coefficients. Unsigned chars are divided by 255. The result is empty for other types except
 * floating-point numbers, and for other numbers of components.
 */
RELEVORENDERINGCORE_EXPORT std::vector<float> GetDirectColors(vtkDataArray* values, int type);
}

#endif
