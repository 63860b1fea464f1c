// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Actors/ActorView.h"

#include "vtkActor.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkWindow.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Return the size of the camera's image in pixels: in a tiled image that of one tile, because the
// camera is zoomed.
std::array<int, 2> GetSize(vtkRenderer* ren)
{
  const int* size = ren->GetSize();
  const int* tiles = ren->GetVTKWindow()->GetTileScale();
  return { { size[0] / tiles[0], size[1] / tiles[1] } };
}
}

RefinementView MakeActorView(vtkRenderer* ren, vtkActor* act)
{
  RefinementView view;
  view.Camera = ren->GetActiveCamera();
  view.ModelToWorld = act->GetMatrix();
  std::copy_n(GetSize(ren).data(), 2, view.ViewportSize);
  return view;
}

std::array<double, 2> GetViewMargins(vtkRenderer* ren, double width)
{
  const std::array<int, 2> size = GetSize(ren);
  return { { width / std::max(size[0], 1), width / std::max(size[1], 1) } };
}

bool MovesVertices(vtkActor* act)
{
  vtkShaderProperty* shaders = act->GetShaderProperty();
  bool moves = shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode();
  for (int i = 0; i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    moves = moves || shaders->GetNthShaderReplacementTypeAsString(i) != "Fragment";
  }
  return moves;
}
}
