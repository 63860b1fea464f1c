// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a relief of what was captured
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

/// nullptr if nothing was drawn. Cropped: without rows and columns at the sides where nothing was.
vtkSmartPointer<vtkImageData> MakeCapturedImage(
  const CapturedPixels& pixels, const FittedCamera& camera, bool withNormals, bool cropped);
}

#endif
