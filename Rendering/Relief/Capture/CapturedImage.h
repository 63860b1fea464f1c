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

/// Return the relief, or nullptr if nothing was drawn. Cropped reliefs have no empty rows and
/// columns at the sides.
vtkSmartPointer<vtkImageData> MakeCapturedImage(
  const CapturedPixels& pixels, const FittedCamera& camera, bool withNormals, bool cropped);
}

#endif
