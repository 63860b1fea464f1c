// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/MeshPlanes.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
bool MeshPlanes::Compute(vtkPlaneCollection* planes, const dmat4& meshToWorld)
{
  this->Planes.clear();
  const int count = planes ? planes->GetNumberOfItems() : 0;
  for (int i = 0; i < std::min(count, MaximumPlanes); ++i)
  {
    auto* plane = vtkPlane::SafeDownCast(planes->GetItemAsObject(i));
    dvec3 origin;
    dvec3 normal;
    plane->GetOrigin(&origin.x);
    plane->GetNormal(&normal.x);
    const dvec3 inMesh = transpose(dmat3(meshToWorld)) * normal;
    const double size = length(inMesh);
    const double scale = size > 0.0 ? 1.0 / size : 1.0;
    const dvec4 scaled = scale * dvec4(inMesh, dot(dvec3(meshToWorld[3]) - origin, normal));
    for (int c = 0; c < 4; ++c)
    {
      this->Planes.push_back(static_cast<float>(scaled[c]));
    }
  }
  return count <= MaximumPlanes;
}

void MeshPlanes::SetUniforms(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("clippingPlanes"))
  {
    const int count = static_cast<int>(this->Planes.size() / 4);
    program->SetUniform4fv("clippingPlanes", count, this->Planes.data());
    program->SetUniformi("numberOfClippingPlanes", count);
  }
}
}
