// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Every surface, for tests that run on all of them.
#ifndef RelevoSurfaces_h
#define RelevoSurfaces_h

#include "vtkRefinementSurface.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

// A null pointer means no surface, which is linear. `size` is the length of the mesh, to which a
// procedural surface's amplitude is proportional. RelevoMeshes::AddRandomScalarTags() adds the
// arrays for scalar-tagged surfaces.
std::vector<std::pair<std::string, vtkSmartPointer<vtkRefinementSurface>>> RelevoMakeSurfaces(
  double size = 1.0);

#endif
