// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Reliefs and cameras to warp with.
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
  RelevoDepth Depth; // of a parallel relief; of a perspective one, 60 more
  bool IsFolded;     // whether moderate views see folds
};

/// Plain, bumpy, stepped, folded, with holes, of single texels.
std::vector<RelevoWarpScene> RelevoMakeWarpScenes(int width, int height);

/// In the world a parallel relief's texels are 1 wide and its depths are along z, sheared a bit; a
/// perspective one is seen from the origin along z, 60 away.
vtkSmartPointer<vtkImageData> RelevoMakeWarpRelief(
  const RelevoWarpScene& scene, int width, int height, relevo::ReliefProjection projection);

/// Looks at the middle of such a relief, from x and y aside; x = y = 0 is where the relief is seen
/// from.
vtkSmartPointer<vtkCamera> RelevoMakeWarpCamera(
  int width, int height, relevo::ReliefProjection projection, bool isParallel, double x, double y);

/// Adds normals of unit length that differ from texel to texel.
void RelevoAddWarpNormals(vtkImageData* image);

#endif
