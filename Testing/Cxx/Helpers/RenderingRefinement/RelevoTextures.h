// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Textures for actors of tests.
#ifndef RelevoTextures_h
#define RelevoTextures_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <array>
#include <functional>

namespace RelevoTextures
{
using Texel = std::array<int, 4>;

// Of as many of the texels' components as is said.
vtkSmartPointer<vtkTexture> Make(
  int width, int height, int components, const std::function<Texel(int x, int y)>& getTexel);

// 8 x 8 texels, next to each other of quite other colours.
vtkSmartPointer<vtkTexture> MakeMotley();
}

#endif
