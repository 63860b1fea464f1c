// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/VolumeLights.h"

#include "vtkCollectionIterator.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

namespace relevo
{
namespace
{
void AddColor(const double color[3], double intensity, std::vector<float>& all)
{
  for (int c = 0; c < 3; ++c)
  {
    all.push_back(static_cast<float>(color[c] * intensity));
  }
}
}

void VolumeLights::ReadMaterials(vtkVolumeProperty* property, int numberOfMaterials)
{
  this->Materials.clear();
  for (int i = 0; i < numberOfMaterials; ++i)
  {
    const bool isShaded = property->GetShade(i) != 0;
    for (double value :
      { isShaded ? property->GetAmbient(i) : 1.0, isShaded ? property->GetDiffuse(i) : 0.0,
        isShaded ? property->GetSpecular(i) : 0.0, property->GetSpecularPower(i) })
    {
      this->Materials.push_back(static_cast<float>(value));
    }
  }
}

void VolumeLights::ReadLights(vtkRenderer* renderer, const dmat4& meshToWorld)
{
  this->Places.clear();
  this->Diffuse.clear();
  this->Specular.clear();
  const dmat4 worldToMesh = inverse(meshToWorld);
  vtkCollectionSimpleIterator each;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(each);
  while (vtkLight* light = lights->GetNextLight(each))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    dvec3 position;
    dvec3 focus;
    light->GetTransformedPosition(&position.x);
    light->GetTransformedFocalPoint(&focus.x);
    const dvec3 away = position - focus;
    const dvec4 place = light->GetPositional() ? worldToMesh * dvec4(position, 1.0)
      : length(away) > 0.0                     ? dvec4(normalize(away), 0.0)
                                               : dvec4(0.0, 0.0, 1.0, 0.0);
    for (int c = 0; c < 4; ++c)
    {
      this->Places.push_back(static_cast<float>(place[c]));
    }
    AddColor(light->GetDiffuseColor(), light->GetIntensity(), this->Diffuse);
    AddColor(light->GetSpecularColor(), light->GetIntensity(), this->Specular);
  }
}

void VolumeLights::SetUniforms(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("materials"))
  {
    program->SetUniform4fv(
      "materials", static_cast<int>(this->Materials.size() / 4), this->Materials.data());
  }
  if (program->IsUniformUsed("lightPlaces"))
  {
    const int count = this->GetNumberOfLights();
    program->SetUniform4fv("lightPlaces", count, this->Places.data());
    program->SetUniform3fv("lightDiffuse", count, this->Diffuse.data());
    program->SetUniform3fv("lightSpecular", count, this->Specular.data());
  }
}
}
