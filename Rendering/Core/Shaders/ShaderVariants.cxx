// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ShaderVariants.h"

#include "Compatibility/VTKCompatibility.h"
#include "Shaders/StageShaders.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
ShaderVariants::ShaderVariants(int number)
  : Variants(number)
{
}

ShaderVariants::~ShaderVariants() = default;

Dependencies& ShaderVariants::GetKey(const vtkOpenGLHelper& helper)
{
  return std::find_if(this->Variants.begin(), this->Variants.end(),
    [&helper](const Variant& variant) { return &variant.Helper == &helper; })
    ->Key;
}

void ShaderVariants::SetKey(const vtkOpenGLHelper& helper, const Dependencies& key)
{
  this->GetKey(helper) = key;
}

bool ShaderVariants::Update(
  vtkOpenGLHelper& helper, const Dependencies& sources, const std::function<void()>& update)
{
  if (!helper.Program && sources == this->FailedSources)
  {
    return false; // already reported
  }
  update();
  if (!helper.Program)
  {
    this->FailedSources = sources;
    this->Error =
      "The shaders could not be built; OpenGL's own message gives the reason. The actor's "
      "vtkShaderProperty is part of them.";
  }
  return helper.Program != nullptr;
}

bool ShaderVariants::NeedsBuild(
  vtkOpenGLHelper& helper, bool isNeededByVTK, const Dependencies& key)
{
  const bool hasChanged = this->GetKey(helper).Update(key);
  if (!isNeededByVTK && !hasChanged)
  {
    return false;
  }
  // A program of other sources must not be used instead of one that failed to build.
  helper.Program = AsksLastProgram ? this->NoProgram.Get() : nullptr;
  return true;
}

void ShaderVariants::Build(Shaders& shaders, const std::function<void()>& build)
{
  this->Missing.clear();
  build();
  ++this->NumberOfBuilds;
  this->Error = this->Missing.empty() ? "" : DescribeMissing(this->Missing);
  if (!this->Missing.empty())
  {
    DrawNothing(shaders);
  }
}

bool ShaderVariants::BuildWithStages(vtkOpenGLHelper& helper,
  const std::function<void(Shaders&)>& build,
  const std::function<vtkShaderProgram*(Shaders&)>& link)
{
  StageShaders stages;
  Shaders& shaders = stages.Get();
  build(shaders);
  if (!this->Error.empty())
  {
    return false; // the caller reports it; VTK's shader cache has a program for these shaders
  }
  vtkShaderProgram* program = link(shaders);
  if (program)
  {
    helper.Program = program;
    helper.VAO->ReleaseGraphicsResources(); // it has the attributes of another program
    helper.ShaderSourceTime.Modified();
  }
  return program != nullptr;
}

void ShaderVariants::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Variant& variant : this->Variants)
  {
    variant.Helper.ReleaseGraphicsResources(window);
  }
  this->FailedSources.Clear();
}
}
