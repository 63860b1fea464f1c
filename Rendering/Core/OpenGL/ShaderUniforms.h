// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   GLM's vectors and matrices as uniforms
 *
 * Private to the modules' own sources.
 */
#ifndef ShaderUniforms_h
#define ShaderUniforms_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkShaderProgram.h"

namespace relevo
{
inline void SetVector(vtkShaderProgram* program, const char* name, const dvec4& vector)
{
  const float values[4] = { static_cast<float>(vector.x), static_cast<float>(vector.y),
    static_cast<float>(vector.z), static_cast<float>(vector.w) };
  program->SetUniform4f(name, values);
}

inline void SetMatrix(vtkShaderProgram* program, const char* name, const dmat4& matrix)
{
  float values[16];
  for (int i = 0; i < 16; ++i)
  {
    values[i] = static_cast<float>(matrix[i / 4][i % 4]);
  }
  program->SetUniformMatrix4x4(name, values);
}
}

#endif
