// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoNamedMeshes.h"

#include "RelevoTestMeshes.h"

namespace RelevoMeshes
{
std::vector<NamedMesh> MakeNamedMeshes()
{
  return { { "Triangles", Sphere(9, 7) }, { "Quads", Plane(4, 3) }, { "Cube", Cube() },
    { "Polygons", Cone() }, { "Strips", Strips() }, { "Mixed", Mixed() } };
}
}
