// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/Shading.h"

#include "vtkVolumeProperty.h"

#include <algorithm>

namespace relevo
{
Shading::Shading(
  vtkVolumeProperty* property, const TransferFunctions& functions, const dvec3& toLight)
  : ToLight(toLight)
{
  const size_t count = functions.AreIndependent() ? functions.GetCurves().size() : 1;
  for (size_t i = 0; i < count; ++i)
  {
    const int set = static_cast<int>(i);
    this->Materials.push_back({ property->GetShade(set) != 0, functions.GetShadedComponent(i),
      dvec4(property->GetAmbient(set), property->GetDiffuse(set), property->GetSpecular(set),
        property->GetSpecularPower(set)) });
  }
}

bool Shading::IsOn() const
{
  return std::any_of(this->Materials.begin(), this->Materials.end(),
    [](const Material& material) { return material.IsShaded; });
}

Lights Shading::GetLights(const Gradients& gradients, const dvec3& toEye) const
{
  Lights lights;
  lights.fill(dvec2(1.0, 0.0));
  for (size_t i = 0; i < this->Materials.size(); ++i)
  {
    const Material& material = this->Materials[i];
    if (material.IsShaded)
    {
      lights[i] =
        volumeLight(gradients[material.Component], this->ToLight, toEye, material.Factors);
    }
  }
  return lights;
}
}
