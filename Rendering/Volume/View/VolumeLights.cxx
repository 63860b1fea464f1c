// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/VolumeLights.h"

#include "View/RendererLights.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

namespace relevo
{
namespace
{
void AddColor(const dvec3& color, std::vector<float>& all)
{
  for (int c = 0; c < 3; ++c)
  {
    all.push_back(static_cast<float>(color[c]));
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
  this->Positions.clear();
  this->Diffuse.clear();
  this->Specular.clear();
  const dmat4 worldToMesh = inverse(meshToWorld);
  for (const RendererLight& light : RendererLights(renderer))
  {
    const bool isPositional = light.Position.w > 0.0;
    const dvec4 position = isPositional ? worldToMesh * light.Position : light.Position;
    for (int c = 0; c < 4; ++c)
    {
      this->Positions.push_back(static_cast<float>(position[c]));
    }
    AddColor(light.Diffuse, this->Diffuse);
    AddColor(light.Specular, this->Specular);
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
    program->SetUniform4fv("lightPlaces", count, this->Positions.data());
    program->SetUniform3fv("lightDiffuse", count, this->Diffuse.data());
    program->SetUniform3fv("lightSpecular", count, this->Specular.data());
  }
}
}
