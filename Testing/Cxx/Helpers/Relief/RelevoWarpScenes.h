// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Reliefs and cameras for warping.
#ifndef RelevoWarpScenes_h
#define RelevoWarpScenes_h

#include "RelevoReliefs.h"
#include "vtkCamera.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct RelevoWarpScene
{
  std::string Name;
  RelevoDepth Depth; // for a parallel relief; a perspective one is 60 deeper
  bool IsFolded;     // whether moderate views show folds
};

/// Flat, bumpy, stepped and folded reliefs, one with holes, and one of single texels.
std::vector<RelevoWarpScene> RelevoMakeWarpScenes(int width, int height);

/// A parallel relief has texels 1 wide and depths along z, slightly sheared. A perspective one is
/// seen from the origin along z, at a distance of 60.
vtkSmartPointer<vtkImageData> RelevoMakeWarpRelief(
  const RelevoWarpScene& scene, int width, int height, relevo::ReliefProjection projection);

/// Looks at the centre of such a relief, displaced by x and y. With x = y = 0 it is at the relief's
/// eye.
vtkSmartPointer<vtkCamera> RelevoMakeWarpCamera(
  int width, int height, relevo::ReliefProjection projection, bool isParallel, double x, double y);

/// Adds unit normals that differ from texel to texel.
void RelevoAddWarpNormals(vtkImageData* image);

#endif
