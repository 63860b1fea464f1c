//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Panels: positions in pixels of the window, from the upper left corner.
in vec2 position;
in vec2 texel;
in vec4 color;
uniform vec2 pixelScale;
uniform vec2 pixelOffset;
out vec2 texelVSOutput;
out vec4 colorVSOutput;

void main()
{
  texelVSOutput = texel;
  colorVSOutput = color;
  gl_Position = vec4(position * pixelScale + pixelOffset, 0.0, 1.0);
}
