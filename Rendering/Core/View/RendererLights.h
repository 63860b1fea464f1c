// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RendererLights
 * @brief   a renderer's lights that are on, in numbers
 *
 * Without cones and attenuation. Private to the modules.
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
  /// In world coordinates: a positional light's point, or the unit vector towards a directional
  /// light with 0.
  dvec4 Position;
  dvec3 Diffuse; // times the intensity, as Specular
  dvec3 Specular;
};

class RELEVORENDERINGCORE_EXPORT RendererLights
{
public:
  /// In the renderer's order.
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
