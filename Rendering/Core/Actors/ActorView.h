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

#include "RelevoRenderingCoreModule.h" // for export macro
#include "View/RefinementView.h"

#include <array>

class vtkActor;
class vtkRenderer;

namespace relevo
{
RELEVORENDERINGCORE_EXPORT RefinementView MakeActorView(vtkRenderer* ren, vtkActor* act);

/// How far lines and points of a width in pixels reach to the sides and up and down, as shares of
/// half the view's width and height.
RELEVORENDERINGCORE_EXPORT std::array<double, 2> GetViewMargins(vtkRenderer* ren, double width);

/// Whether the actor has shaders of its own, or parts of them, that write vertices.
RELEVORENDERINGCORE_EXPORT bool MovesVertices(vtkActor* act);
}

#endif
