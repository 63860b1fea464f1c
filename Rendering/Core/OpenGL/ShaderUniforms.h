// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   sets uniforms from GLM's vectors and matrices
 *
 * MakeMatrix() of WorldView.h converts VTK's matrices. Uniforms that the program does not use are
 * ignored. Private to the modules.
 */
#ifndef ShaderUniforms_h
#define ShaderUniforms_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkShaderProgram.h"

namespace relevo
{
inline void SetInteger(vtkShaderProgram* program, const char* name, int value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformi(name, value);
  }
}

inline void SetVector(vtkShaderProgram* program, const char* name, const dvec2& vector)
{
  const float values[2] = { static_cast<float>(vector.x), static_cast<float>(vector.y) };
  program->SetUniform2f(name, values);
}

inline void SetVector(vtkShaderProgram* program, const char* name, const dvec4& vector)
{
  const float values[4] = { static_cast<float>(vector.x), static_cast<float>(vector.y),
    static_cast<float>(vector.z), static_cast<float>(vector.w) };
  program->SetUniform4f(name, values);
}

inline void SetMatrix(vtkShaderProgram* program, const char* name, const dmat3& matrix)
{
  float values[9];
  for (int i = 0; i < 9; ++i)
  {
    values[i] = static_cast<float>(matrix[i / 3][i % 3]);
  }
  program->SetUniformMatrix3x3(name, values);
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
