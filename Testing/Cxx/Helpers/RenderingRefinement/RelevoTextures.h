// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Textures for the actors of tests.
#ifndef RelevoTextures_h
#define RelevoTextures_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <array>
#include <functional>

namespace RelevoTextures
{
using Texel = std::array<int, 4>;

// Uses this many of the texels' components.
vtkSmartPointer<vtkTexture> Make(
  int width, int height, int components, const std::function<Texel(int x, int y)>& getTexel);

// 8 x 8 texels; neighbouring texels have very different colours.
vtkSmartPointer<vtkTexture> MakeMotley();
}

#endif
