// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Textures for actors of tests.
#ifndef RelevoTextures_h
#define RelevoTextures_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"

namespace RelevoTextures
{
// 8 x 8 texels, next to each other of quite other colours.
vtkSmartPointer<vtkTexture> MakeMotley();
}

#endif
