// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RendererLights.h"

#include "vtkCollectionIterator.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

namespace relevo
{
namespace
{
dvec3 ToVector(const double values[3])
{
  return dvec3(values[0], values[1], values[2]);
}

// A light at its focal point gets the direction of VTK's default light.
dvec3 GetDirection(const dvec3& away)
{
  return length(away) > 0.0 ? normalize(away) : dvec3(0.0, 0.0, 1.0);
}
}

RendererLights::RendererLights(vtkRenderer* renderer)
{
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
    RendererLight found;
    found.Position =
      light->GetPositional() ? dvec4(position, 1.0) : dvec4(GetDirection(position - focus), 0.0);
    found.Diffuse = light->GetIntensity() * ToVector(light->GetDiffuseColor());
    found.Specular = light->GetIntensity() * ToVector(light->GetSpecularColor());
    this->Lights.push_back(found);
  }
}
}
