// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// How many primitives OpenGL itself makes of what is drawn.
#ifndef RelevoPrimitiveCount_h
#define RelevoPrimitiveCount_h

#include "RelevoScene.h"

namespace RelevoPrimitiveCount
{
// Primitives of one render.
vtkIdType CountPrimitives(RelevoScene& scene);

// Those of the first actor, which draws triangles only.
vtkIdType CountTriangles(RelevoScene& scene);
}

#endif
