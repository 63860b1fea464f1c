// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   properties of an actor in a renderer's view
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

/// Return how far lines and points of a width in pixels extend horizontally and vertically, as
/// fractions of half the view's width and height.
RELEVORENDERINGCORE_EXPORT std::array<double, 2> GetViewMargins(vtkRenderer* ren, double width);

/// Return whether the actor has its own vertex shader code, or parts of it.
RELEVORENDERINGCORE_EXPORT bool MovesVertices(vtkActor* act);
}

#endif
