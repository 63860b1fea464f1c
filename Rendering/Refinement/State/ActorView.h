// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a renderer sees of an actor
 *
 * Private to the modules.
 */
#ifndef ActorView_h
#define ActorView_h

#include "Core/RefinementView.h"
#include "RelevoRenderingRefinementModule.h" // for export macro

#include <array>

class vtkActor;
class vtkRenderer;

namespace relevo
{
RELEVORENDERINGREFINEMENT_EXPORT RefinementView MakeActorView(vtkRenderer* ren, vtkActor* act);

/// What lines and points of a width in pixels reach to the sides and up and down, as shares of half
/// the view's width and height.
RELEVORENDERINGREFINEMENT_EXPORT std::array<double, 2> GetViewMargins(
  vtkRenderer* ren, double width);

/// Whether the actor has shaders of its own, or parts of them, that write vertices.
RELEVORENDERINGREFINEMENT_EXPORT bool MovesVertices(vtkActor* act);
}

#endif
