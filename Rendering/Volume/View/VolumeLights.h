// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeLights
 * @brief   a renderer's lights and the materials of a volume
 *
 * Private to the module.
 */
#ifndef VolumeLights_h
#define VolumeLights_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

class vtkRenderer;
class vtkShaderProgram;
class vtkVolumeProperty;

namespace relevo
{
class VolumeLights
{
public:
  /// Read the materials of this number of components. Colours of unshaded components do not change.
  void ReadMaterials(vtkVolumeProperty* property, int numberOfMaterials);

  /// Read the lights that are on.
  void ReadLights(vtkRenderer* renderer, const dmat4& meshToWorld);

  int GetNumberOfLights() const { return static_cast<int>(this->Positions.size() / 4); }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  std::vector<float> Materials; // 4 each
  std::vector<float> Positions; // 4 each
  std::vector<float> Diffuse;   // 3 each
  std::vector<float> Specular;
};
}

#endif
