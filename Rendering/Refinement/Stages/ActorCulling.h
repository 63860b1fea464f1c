// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether faces of an actor can be culled
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

/// Return the camera's view of a mesh; nullptr if the actor's own shaders move vertices.
std::unique_ptr<CullingView> MakeCullingView(
  vtkRenderer* renderer, vtkActor* actor, const RefinementMesh& mesh);

/// Return whether no setting of the actor shows the back faces of its closed surface.
bool HidesBackFaces(vtkActor* actor);

/**
 * Return whether colours that VTK treats as opaque are translucent, such as those of vectors with
 * four components. VTK draws them with the opaque surfaces, although they show the geometry behind
 * them.
 */
bool AreTranslucent(vtkUnsignedCharArray* colors);
}

#endif
