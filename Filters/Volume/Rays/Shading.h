// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Shading
 * @brief   what a headlight does to the colours of a volume whose property is shaded
 *
 * Private to the module's own sources.
 */
#ifndef Shading_h
#define Shading_h

#include "Cells/Ray.h"

#include <vector>

class vtkVolumeProperty;

namespace relevo
{
class Shading
{
public:
  /// Light comes along -toLight, of length 1, all over.
  Shading(vtkVolumeProperty* property, const TransferFunctions& functions, const dvec3& toLight);

  /// Whether there is a component that is shaded.
  bool IsOn() const;

  /// Of each curve of the functions, or of the colours, where components have these gradients.
  Lights GetLights(const Gradients& gradients, const dvec3& toEye) const;

private:
  struct Material
  {
    bool IsShaded;
    int Component; // whose gradients count
    dvec4 Factors; // ambient, diffuse, specular, specular power
  };
  std::vector<Material> Materials;
  dvec3 ToLight;
};
}

#endif
