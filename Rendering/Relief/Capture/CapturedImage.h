// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   converts captured pixels to a relief
 *
 * Private to the module.
 */
#ifndef CapturedImage_h
#define CapturedImage_h

#include "vtkSmartPointer.h"

class vtkCamera;
class vtkImageData;

namespace relevo
{
struct CapturedPixels;
struct FittedCamera;

/// Columns and rows, from the first to one past the last.
struct PixelWindow
{
  int Begin[2];
  int End[2];
};

/// Return the smallest window with all pixels that were drawn; the ends are 0 if there are none.
PixelWindow FindDrawn(const CapturedPixels& pixels);

/// Return the relief, or nullptr if nothing was drawn. Cropped reliefs have no empty rows and
/// columns at the sides.
vtkSmartPointer<vtkImageData> MakeCapturedImage(
  const CapturedPixels& pixels, const FittedCamera& camera, bool withNormals, bool cropped);
}

#endif
