// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   OpenGL without a display, and its limits
 */
#ifndef OffscreenWindow_h
#define OffscreenWindow_h

#include "vtkSmartPointer.h"

class vtkHeightMap;
class vtkRenderWindow;

vtkSmartPointer<vtkRenderWindow> NewOffscreenWindow();

/**
 * If the height map or the picture over it (by file name, or "") is larger than all OpenGL
 * implementations support, limits the height map's MaximumDimension to the size of a texture of
 * this one.
 */
void FitIntoTexture(vtkHeightMap* heights, const char* picture);

#endif
