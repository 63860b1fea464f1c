// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Actors/ShaderVariantKey.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"

namespace relevo
{
namespace
{
void AddProperty(Dependencies& key, vtkProperty* property)
{
  const double width = property->GetLineWidth();
  for (int value : { property->GetRepresentation(), property->GetInterpolation(),
         property->GetLighting() ? 1 : 0, static_cast<int>(property->GetEdgeVisibility()),
         static_cast<int>(property->GetVertexVisibility()),
         property->GetRenderPointsAsSpheres() ? 1 : 0, property->GetRenderLinesAsTubes() ? 1 : 0,
         property->GetCoatStrength() > 0.0 ? 1 : 0, property->GetAnisotropy() != 0.0 ? 1 : 0 })
  {
    key.Add(value);
  }
  key.Add(width); // a geometry shader draws lines wider than OpenGL supports
}

// Most actors have no shader code of their own.
const void* GetOwnShader(vtkShaderProperty* shader)
{
  const bool isOwn = shader->HasVertexShaderCode() || shader->HasGeometryShaderCode() ||
    shader->HasFragmentShaderCode() || shader->GetNumberOfShaderReplacements() > 0 ||
    shader->GetVertexCustomUniforms()->GetNumberOfUniforms() > 0 ||
    shader->GetGeometryCustomUniforms()->GetNumberOfUniforms() > 0 ||
    shader->GetFragmentCustomUniforms()->GetNumberOfUniforms() > 0;
  return isOwn ? shader : nullptr;
}

// Render passes change often, and VTK compares them.
const void* GetOwnKeys(vtkInformation* keys)
{
  const int passes = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()) ? 1 : 0;
  return keys && keys->GetNumberOfKeys() > passes ? keys : nullptr;
}
}

Dependencies GetShaderVariantKey(
  vtkRenderer* ren, vtkActor* act, const std::vector<NamedTexture>& textures)
{
  Dependencies key;
  AddProperty(key, act->GetProperty());
  // An object that replaces a deleted one is newer than the shaders, which VTK detects.
  key.AddObject(GetOwnShader(act->GetShaderProperty()), act->GetBackfaceProperty() ? 1 : 0);
  key.AddObject(GetOwnKeys(act->GetPropertyKeys()), textures.size());
  for (const NamedTexture& texture : textures)
  {
    key.AddObject(texture.first, 0);
    key.Add(texture.second);
  }
  vtkOpenGLRenderer* renderer = vtkOpenGLRenderer::SafeDownCast(ren);
  for (int value : { renderer->GetLightingComplexity(), renderer->GetLightingCount(),
         renderer->GetUseImageBasedLighting() ? 1 : 0, renderer->GetUseSphericalHarmonics() ? 1 : 0,
         ren->GetActiveCamera()->GetParallelProjection() ? 1 : 0 })
  {
    key.Add(value);
  }
  key.AddObject(renderer->GetEnvironmentTexture(), 0);
  return key;
}

bool HasOwnFragments(vtkActor* act)
{
  vtkShaderProperty* shader = act->GetShaderProperty();
  bool isOwn = shader->HasFragmentShaderCode();
  for (int i = 0; i < shader->GetNumberOfShaderReplacements(); ++i)
  {
    isOwn = isOwn || shader->GetNthShaderReplacementTypeAsString(i) == "Fragment";
  }
  return isOwn;
}
}
