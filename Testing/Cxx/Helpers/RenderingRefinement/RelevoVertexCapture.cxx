// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoVertexCapture.h"

#include "OpenGL/RelevoOpenGL.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cstring>

RelevoVertexCapture::RelevoVertexCapture(vtkActor* actor, size_t maximumVertices)
  : Most(maximumVertices)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->AddVertexShaderReplacement("//VTK::System::Dec", false, "#version 430\n", false);
  shaders->AddVertexShaderReplacement("//VTK::CustomUniforms::Dec", true,
    "//VTK::CustomUniforms::Dec\n"
    "layout(std430, binding = 0) buffer CapturedVertices\n"
    "{\n  uint capturedCount;\n  float captured[];\n};\n",
    false);
  shaders->AddVertexShaderReplacement("//VTK::CustomEnd::Impl", true,
    "//VTK::CustomEnd::Impl\n"
    "  uint place = 3u * atomicAdd(capturedCount, 1u);\n"
    "  if (place + 2u < uint(captured.length()))\n  {\n"
    "    captured[place] = vertexMC.x;\n"
    "    captured[place + 1u] = vertexMC.y;\n"
    "    captured[place + 2u] = vertexMC.z;\n  }\n",
    false);
}

RelevoVertexCapture::Points RelevoVertexCapture::Capture(RelevoCheck& check, RelevoScene& scene)
{
  scene.Render();
  const GLsizeiptr size = static_cast<GLsizeiptr>((3 * this->Most + 1) * sizeof(float));
  std::vector<float> values(3 * this->Most + 1, 0.0f);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, size, values.data(), GL_DYNAMIC_READ);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
  scene.Render();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, size, values.data());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  glDeleteBuffers(1, &buffer);
  unsigned int count = 0;
  std::memcpy(&count, values.data(), sizeof(count));
  CHECK_GREATER(count, 0);
  CHECK_LESS_EQUAL(count, this->Most);
  Points points;
  for (size_t i = 0; i < std::min<size_t>(count, this->Most); ++i)
  {
    points.insert({ { values[3 * i + 1], values[3 * i + 2], values[3 * i + 3] } });
  }
  return points;
}
