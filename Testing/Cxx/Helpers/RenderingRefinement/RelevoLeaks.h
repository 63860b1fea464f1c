// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts pixels that show a crack in a closed surface, or a triangle that faces the wrong side:
// each pixel is covered by as many triangles seen from the front as from the back, so the front
// faces alone and the back faces alone must fill exactly the same pixels.
#ifndef RelevoLeaks_h
#define RelevoLeaks_h

#include "RelevoScene.h"

namespace RelevoLeaks
{
bool IsClosed(vtkPolyData* mesh);

// Views from all around at what is seen edge-on; returns the pixels that front and back faces do
// not agree on.
size_t CountLeaks(RelevoScene& scene, int views, size_t& covered);

vtkActor* AddWhite(RelevoScene& scene, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe);
}

#endif
