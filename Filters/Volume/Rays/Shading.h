// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Shading
 * @brief   lighting of a volume by a headlight
 *
 * Private to the module.
 */
#ifndef Shading_h
#define Shading_h

#include "Integral/Ray.h"

#include <vector>

class vtkVolumeProperty;

namespace relevo
{
class Shading
{
public:
  /// `toLight` is normalized. The light is directional.
  Shading(vtkVolumeProperty* property, const TransferFunctions& functions, const dvec3& toLight);

  /// Whether any component is shaded.
  bool IsOn() const;

  /// Returns the lighting of each curve, or of the colours, for the given gradients.
  Lights GetLights(const Gradients& gradients, const dvec3& toEye) const;

private:
  struct Material
  {
    bool IsShaded;
    int Component; // component with the gradients
    dvec4 Factors; // ambient, diffuse, specular, specular power
  };
  std::vector<Material> Materials;
  dvec3 ToLight;
};
}

#endif
