// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RendererLights
 * @brief   the parameters of a renderer's lights that are on
 *
 * Cones and attenuation are ignored. Private to the modules.
 */
#ifndef RendererLights_h
#define RendererLights_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoRenderingCoreModule.h" // for export macro

#include <vector> // for members

class vtkRenderer;

namespace relevo
{
struct RendererLight
{
  /// World coordinates: the position of a positional light, or the unit vector towards a
  /// directional light with w = 0.
  dvec4 Position;
  dvec3 Diffuse; // multiplied by the intensity, like Specular
  dvec3 Specular;
};

class RELEVORENDERINGCORE_EXPORT RendererLights
{
public:
  /// Collect the lights in the renderer's order.
  explicit RendererLights(vtkRenderer* renderer);

  bool IsEmpty() const { return this->Lights.empty(); }
  const RendererLight& GetFirst() const { return this->Lights.front(); }
  std::vector<RendererLight>::const_iterator begin() const { return this->Lights.begin(); }
  std::vector<RendererLight>::const_iterator end() const { return this->Lights.end(); }

private:
  std::vector<RendererLight> Lights;
};
}

#endif
