// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SurfaceBuffer.h"

#include "Rays/IsoSurfaces.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double Opaque = 0.999; // as in relevoVolumePart.glsl
}

bool SurfaceBuffer::Upload(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
  const TransferFunctions& functions, const Scalars& low, const Scalars& size)
{
  const IsoSurfaces surfaces(property, functions);
  this->Component = surfaces.GetComponent();
  this->Curve = static_cast<int>(surfaces.GetCurve());
  this->ScaledValues.clear();
  const double least = low[this->Component];
  const double range = size[this->Component];
  const double largest = std::max(std::abs(least), std::abs(least + range));
  this->Same = static_cast<float>(IsoSurfaces::Same * std::max(largest / range, 1.0));
  this->IsOpaque = true;
  std::vector<float> texels;
  for (double value : surfaces.GetValues())
  {
    const dvec4 color = surfaces.GetColor(functions, {}, { 0, 0.0, value });
    this->IsOpaque = this->IsOpaque && color.w >= Opaque;
    for (double number : { std::clamp((value - least) / range, -1.0, 2.0), 0.0, 0.0, 0.0, color.x,
           color.y, color.z, color.w })
    {
      texels.push_back(static_cast<float>(number));
    }
    this->ScaledValues.push_back(texels[texels.size() - 8]);
  }
  return this->Values.Upload(window, texels, 4);
}

void SurfaceBuffer::Activate(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("isoValues"))
  {
    this->Values.Activate(program, "isoValues");
    program->SetUniformi("numberOfIsoValues", static_cast<int>(this->ScaledValues.size()));
    program->SetUniformi("isoCurve", this->Curve);
    program->SetUniformf("isoSame", this->Same);
  }
  program->SetUniformi("isoComponent", this->Component);
}
}
