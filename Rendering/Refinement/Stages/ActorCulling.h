// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what of an actor's mesh can be culled
 *
 * Private to the module.
 */
#ifndef ActorCulling_h
#define ActorCulling_h

#include <memory>

class vtkActor;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace relevo
{
class RefinementMesh;
struct CullingView;

/// The part of a mesh that a camera sees; nullptr where the actor's own shaders move vertices.
std::unique_ptr<CullingView> MakeCullingView(
  vtkRenderer* renderer, vtkActor* actor, const RefinementMesh& mesh);

/// Whether an actor has nothing that shows the back faces of its closed surface.
bool HidesBackFaces(vtkActor* actor);

/**
 * Whether colours that VTK calls opaque are translucent, as those of vectors of four components.
 * VTK draws them with its opaque surfaces, and yet shows what is behind.
 */
bool AreTranslucent(vtkUnsignedCharArray* colors);
}

#endif
