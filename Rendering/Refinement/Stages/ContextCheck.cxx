// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/ContextCheck.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Compute/RefinementComputeProgram.h"
#include "OpenGL/ContextFacts.h"

#include <string>

namespace relevo
{
StageResult ContextCheck::Update(int selectionDevice)
{
  StageResult result;
  if (!this->IsChecked)
  {
    this->IsChecked = true;
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    const std::string version = std::to_string(major) + "." + std::to_string(minor);
    const bool instancing = major > 3 || (major == 3 && minor >= 3);
    const bool rgbBuffers = HasBuffersOfThreeFloats();
    this->IsValid = instancing && rgbBuffers;
    if (!this->IsValid)
    {
      result.Errors.push_back(
        "Refinement needs OpenGL 3.3 with ARB_texture_buffer_object_rgb32 (part of OpenGL 4.0); "
        "this context has OpenGL " +
        version + (rgbBuffers ? " with it" : " without one that works") + " (" +
        GetOpenGLRenderer() + ").");
    }
    this->HasCompute = this->IsValid && selectionDevice != SELECTION_DEVICE_CPU &&
      RefinementComputeProgram::IsSupported();
    if (selectionDevice == SELECTION_DEVICE_AUTOMATIC)
    {
      this->HasCompute = this->HasCompute && IsHardwareRenderer();
    }
    else if (this->IsValid && !this->HasCompute && selectionDevice == SELECTION_DEVICE_GPU)
    {
      result.Errors.push_back("Selection on the GPU needs OpenGL 4.3; this context has OpenGL " +
        version + ". The CPU is used instead.");
    }
  }
  result.IsValid = this->IsValid;
  return result;
}
}
