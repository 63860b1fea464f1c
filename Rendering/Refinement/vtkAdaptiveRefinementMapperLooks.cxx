// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Programs for each look of the actors and renderers that share a mapper.
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "vtkActor.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr size_t MostLooks = 32;

// All but the indices, which depend on the mesh and the representation.
void SwapPrograms(vtkOpenGLHelper& a, vtkOpenGLHelper& b)
{
  std::swap(a.Program, b.Program);
  std::swap(a.ShaderSourceTime, b.ShaderSourceTime);
  std::swap(a.VAO, b.VAO);
  std::swap(a.AttributeUpdateTime, b.AttributeUpdateTime);
  std::swap(a.ShaderChangeValue, b.ShaderChangeValue);
}
}

void vtkAdaptiveRefinementMapper::vtkInternals::SwapLook(
  vtkAdaptiveRefinementMapper* mapper, Look& look)
{
  std::vector<vtkOpenGLHelper*> helpers = this->Helpers;
  for (int i = PrimitiveStart; i < PrimitiveEnd; ++i)
  {
    helpers.push_back(&mapper->Primitives[i]);
    helpers.push_back(&mapper->SelectionPrimitives[i]);
  }
  for (vtkOpenGLHelper* helper : helpers)
  {
    std::unique_ptr<vtkOpenGLHelper>& other = look.Helpers[helper];
    if (!other)
    {
      other.reset(new vtkOpenGLHelper);
    }
    SwapPrograms(*helper, *other);
  }
  std::swap(mapper->PrimitiveInfo, look.Info);
  std::swap(this->Programs, look.Programs);
  std::swap(this->Failure, look.Failure);
}

void vtkAdaptiveRefinementMapper::FollowLook(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const relevo::Dependencies look = relevo::GetShaderVariantKey(ren, act, this->GetTextures(act));
  if (data.CurrentLook == look)
  {
    return;
  }
  if (!data.CurrentLook.IsEmpty())
  {
    vtkInternals::Look& last = data.Looks[data.CurrentLook];
    data.SwapLook(this, last);
    vtkInternals::Look& next = data.Looks[look];
    data.SwapLook(this, next);
    next.LastUse = ++data.LookUse;
  }
  data.CurrentLook = look;
  if (data.Looks.size() > MostLooks)
  {
    const auto oldest = std::min_element(data.Looks.begin(), data.Looks.end(),
      [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; });
    for (auto& helper : oldest->second.Helpers)
    {
      helper.second->ReleaseGraphicsResources(ren->GetRenderWindow());
    }
    data.Looks.erase(oldest);
  }
}

void vtkAdaptiveRefinementMapper::vtkInternals::ReleaseLooks(vtkWindow* window)
{
  for (auto& look : this->Looks)
  {
    for (auto& helper : look.second.Helpers)
    {
      helper.second->ReleaseGraphicsResources(window);
    }
  }
  this->Looks.clear();
}

void vtkAdaptiveRefinementMapper::vtkInternals::ForgetPrograms(int method)
{
  const auto forget = [method](vtkOpenGLHelper& helper, ProgramState& program)
  {
    if (program.Method == method)
    {
      helper.Program = nullptr;
      program.Method = -1;
    }
  };
  for (vtkOpenGLHelper* helper : this->Helpers)
  {
    forget(*helper, this->Programs[helper]);
    for (auto& look : this->Looks)
    {
      forget(*look.second.Helpers[helper], look.second.Programs[helper]);
    }
  }
}
