// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RenderPasses.h"

#include "vtkAbstractMapper.h"
#include "vtkInformation.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

namespace relevo
{
RenderPasses::RenderPasses(vtkAbstractMapper* mapper, vtkProp* prop)
  : Mapper(mapper)
  , Prop(prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  const int count = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())
    ? keys->Length(vtkOpenGLRenderPass::RenderPasses())
    : 0;
  for (int i = 0; i < count; ++i)
  {
    if (auto* pass =
          vtkOpenGLRenderPass::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
    {
      this->Passes.push_back(pass);
    }
  }
}

void RenderPasses::ReplaceShaderValues(std::string& fragmentShader) const
{
  std::string none;
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->PreReplaceShaderValues(none, none, fragmentShader, this->Mapper, this->Prop);
    pass->PostReplaceShaderValues(none, none, fragmentShader, this->Mapper, this->Prop);
  }
}

void RenderPasses::SetShaderParameters(
  vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertices) const
{
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->SetShaderParameters(program, this->Mapper, this->Prop, vertices);
  }
}
}
