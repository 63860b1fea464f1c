// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Every surface, for tests that all of them must pass.
#ifndef RelevoSurfaces_h
#define RelevoSurfaces_h

#include "vtkRefinementSurface.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

// A null pointer stands for no surface, which is linear. `size` is the length of a mesh, which a
// procedural surface's amplitude goes by; RelevoMeshes::AddRandomScalarTags() gives the mesh what
// scalar-tagged surfaces take.
std::vector<std::pair<std::string, vtkSmartPointer<vtkRefinementSurface>>> RelevoMakeSurfaces(
  double size = 1.0);

#endif
