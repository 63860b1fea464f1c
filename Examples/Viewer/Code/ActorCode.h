// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds actors and volumes to the program of a scene
 */
#ifndef ActorCode_h
#define ActorCode_h

#include <string>

class SceneCode;
class vtkActor;
class vtkVolume;

/// Adds an actor with its mapper, and returns its variable. The code must know the mapper's input.
/// Throws ViewerError.
std::string AddActorCode(SceneCode& code, vtkActor* actor);

/// The same for the volume of a mesh.
std::string AddVolumeCode(SceneCode& code, vtkVolume* volume);

#endif
