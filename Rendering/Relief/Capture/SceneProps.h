// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the props of a renderer that can be captured
 *
 * Private to the module.
 */
#ifndef SceneProps_h
#define SceneProps_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

class vtkProp;
class vtkRenderer;

namespace relevo
{
struct SceneProps
{
  /// Visible props with opaque geometry and finite bounds.
  std::vector<vtkProp*> Opaque;
  /// The corners of the bounds of each of them, in world coordinates.
  std::vector<dvec3> Corners;
  /// The number of visible props with translucent geometry, and of volumes.
  int NumberOfTranslucent = 0;
  int NumberOfVolumes = 0;
};

/// The props to look for.
enum class SceneParts
{
  All,
  // opaque props with surfaces only: no lines, points or parts that rotate with the camera
  Surfaces
};

SceneProps FindSceneProps(vtkRenderer* renderer, SceneParts parts);
}

#endif
