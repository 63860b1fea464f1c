// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of every kind of cells, for tests that all of them must pass.
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
