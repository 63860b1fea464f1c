//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
in vec2 texelVSOutput;
in vec4 colorVSOutput;
uniform sampler2D atlas;

void main()
{
  gl_FragData[0] = colorVSOutput * texture(atlas, texelVSOutput);
}
