// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   tables of patches for relevoPatchSurface.glsl
 *
 * Private to the module.
 */
#ifndef PatchTables_h
#define PatchTables_h

#include "Mesh/FaceCorners.h"
#include "vtkRefinementSurface.h"

namespace relevo
{
using PatchCorners = FaceCorners<vtkRefinementSurface::Face>;

/// A face of a mesh with tables, evaluated in C++.
struct PatchFace : PatchCorners
{
  explicit PatchFace(const vtkRefinementSurface::Face& face)
    : PatchCorners{ face, 0 }
    , lastPoint()
  {
  }

#include "glsl/relevoPatch.glsl"
#include "glsl/relevoPatchSurface.glsl"
};

/// See vtkRefinementSurface::BuildTables().
bool BuildPatchTables(vtkPolyData* mesh, const double origin[3],
  vtkRefinementSurface::Tables& tables, std::string& error);
}

#endif
