// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of every kind of cells, for tests that run on all of them.
#ifndef RelevoNamedMeshes_h
#define RelevoNamedMeshes_h

#include "RelevoMeshArrays.h"

#include <string>
#include <vector>

namespace RelevoMeshes
{
struct NamedMesh
{
  std::string Name;
  Mesh Data;
};

std::vector<NamedMesh> MakeNamedMeshes();
}

#endif
