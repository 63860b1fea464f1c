// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/ActorCulling.h"

#include "Actors/ActorView.h"
#include "Mesh/RefinementMesh.h"
#include "View/CullingView.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Return whether an actor that is drawn as opaque is transparent in some regions.
bool HasGaps(vtkActor* actor)
{
  vtkTexture* texture = actor->GetTexture();
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return actor->GetForceOpaque() || actor->GetProperty()->GetOpacity() < 1.0 ||
    actor->GetProperty()->GetTexture("albedoTex") ||
    (texture && (!image || image->GetNumberOfScalarComponents() != 3)) ||
    shaders->HasFragmentShaderCode() || shaders->GetNumberOfShaderReplacements() > 0;
}
}

std::unique_ptr<CullingView> MakeCullingView(
  vtkRenderer* renderer, vtkActor* actor, const RefinementMesh& mesh)
{
  if (MovesVertices(actor))
  {
    return nullptr;
  }
  // Lines and points have a width in pixels.
  vtkProperty* property = actor->GetProperty();
  double width = 0.0;
  if (property->GetRepresentation() != VTK_SURFACE || property->GetVertexVisibility())
  {
    width = std::max(property->GetLineWidth(), property->GetPointSize());
  }
  return std::make_unique<CullingView>(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(),
    actor->GetMatrix(), mesh.Origin, GetViewMargins(renderer, width));
}

bool HidesBackFaces(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  return property->GetRepresentation() == VTK_SURFACE && !property->GetFrontfaceCulling() &&
    !property->GetVertexVisibility() && !property->GetEdgeVisibility() && !HasGaps(actor) &&
    !MovesVertices(actor) && actor->GetMatrix()->Determinant() > 0.0;
}

bool AreTranslucent(vtkUnsignedCharArray* colors)
{
  return colors && colors->GetNumberOfComponents() == 4 && colors->GetNumberOfTuples() > 0 &&
    colors->GetRange(3)[0] < 255.0;
}
}
