// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/RefinementEvaluator.h"

#include "Mesh/FaceDisplacement.h"

#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkLinearSurface.h"
#include "vtkSmartPointer.h"

namespace relevo
{
struct RefinementEvaluator::Internals
{
  const RefinementMesh& Mesh;
  vtkSmartPointer<vtkRefinementSurface> Surface;
  std::unique_ptr<FaceDisplacement> Displaced;
};

RefinementEvaluator::RefinementEvaluator(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
  : Data(new Internals{ mesh, recipe->GetSurface(), nullptr })
{
  if (!this->Data->Surface)
  {
    this->Data->Surface = vtkSmartPointer<vtkLinearSurface>::New();
  }
  if (recipe->GetDisplacement() && !mesh.Faces.empty())
  {
    this->Data->Displaced.reset(new FaceDisplacement(mesh, recipe->GetDisplacement(),
      this->Data->Surface->HasDirections() ? this->Data->Surface.Get() : nullptr));
  }
}

RefinementEvaluator::~RefinementEvaluator() = default;

void RefinementEvaluator::Evaluate(
  int face, const float weights[3], float position[3], float normal[3]) const
{
  const Internals& data = *this->Data;
  const vtkRefinementSurface::Face corners = data.Mesh.GetSurfaceFace(face);
  data.Surface->Evaluate(corners, weights, position, normal);

  vec3 n = SurfaceCorners::Load(normal);
  if (data.Displaced)
  {
    FaceDisplacement displaced = *data.Displaced;
    displaced.Face = face;
    const FaceDisplacement::DisplacedPoint point =
      displaced.displace(SurfaceCorners::Load(weights), n);
    for (int c = 0; c < 3; ++c)
    {
      position[c] += point.Vector[c];
    }
    n = point.Normal;
  }
  n = unitVector(n);
  for (int c = 0; c < 3; ++c)
  {
    // -0 would give different bits for the same point or normal.
    position[c] += 0.0f;
    normal[c] = n[c] + 0.0f;
  }
}
}
