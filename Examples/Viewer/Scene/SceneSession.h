// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   saves the state of a scene as a session
 */
#ifndef SceneSession_h
#define SceneSession_h

#include "Options/SessionFile.h"

struct ViewerOptions;
class ViewerScene;
class vtkRenderer;

/// Sets the camera of a session.
void SetCamera(vtkRenderer* renderer, const SessionCamera& camera);

/// The camera of a scene.
SessionCamera GetCamera(vtkRenderer* renderer);

/// Writes options.SaveSession: the options that were given, and the camera. Throws ViewerError.
void SaveSceneSession(ViewerScene& scene, const ViewerOptions& options);

/// SaveSceneSession() with changes by keys.
void SaveSession(ViewerScene& scene, const ViewerOptions& options);

#endif
