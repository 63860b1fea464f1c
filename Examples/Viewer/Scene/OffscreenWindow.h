// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   OpenGL without a display, and what it can hold
 */
#ifndef OffscreenWindow_h
#define OffscreenWindow_h

#include "vtkSmartPointer.h"

class vtkHeightMap;
class vtkRenderWindow;

vtkSmartPointer<vtkRenderWindow> NewOffscreenWindow();

/**
 * Lowers the height map's MaximumDimension to what a texture of this OpenGL can have, where it or a
 * picture over it, by its file name or "", is larger than what all have.
 */
void FitIntoTexture(vtkHeightMap* heights, const char* picture);

#endif
