// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts pixels that show a crack in a closed surface or a triangle of wrong winding. In each pixel
// as many triangles face the eye as face away, so front faces alone and back faces alone must cover
// exactly the same pixels.
#ifndef RelevoLeaks_h
#define RelevoLeaks_h

#include "RelevoScene.h"

namespace RelevoLeaks
{
bool IsClosed(vtkPolyData* mesh);

// Draws views from all sides in which silhouettes are prominent. Returns the number of pixels where
// front and back faces differ.
size_t CountLeaks(RelevoScene& scene, int views, size_t& covered);

vtkActor* AddWhite(RelevoScene& scene, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe);
}

#endif
