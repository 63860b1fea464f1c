// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts primitives by OpenGL queries.
#ifndef RelevoPrimitiveCount_h
#define RelevoPrimitiveCount_h

#include "RelevoScene.h"

namespace RelevoPrimitiveCount
{
// Primitives of one frame.
vtkIdType CountPrimitives(RelevoScene& scene);

// Triangles of the first actor, which draws only triangles.
vtkIdType CountTriangles(RelevoScene& scene);
}

#endif
