// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what of a renderer's props can be captured
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
  /// Visible, with opaque parts and finite bounds.
  std::vector<vtkProp*> Opaque;
  /// Corners of the bounds of each of them, in the world.
  std::vector<dvec3> Corners;
  /// Visible ones that have translucent parts, and volumes.
  int NumberOfTranslucent = 0;
  int NumberOfVolumes = 0;
};

/// What of a scene is looked for.
enum class SceneParts
{
  All,
  Surfaces ///< of opaque props those whose parts are all drawn as surfaces: no lines,
           ///< no points, nothing that turns with the camera
};

SceneProps FindSceneProps(vtkRenderer* renderer, SceneParts parts);
}

#endif
