// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   saves the state of a scene as a session
 */
#ifndef SceneSession_h
#define SceneSession_h

struct ViewerOptions;
struct SessionCamera;
class ViewerScene;
class vtkRenderer;

/// Sets the camera of a session.
void SetCamera(vtkRenderer* renderer, const SessionCamera& camera);

/// Writes options.SaveSession: the options that were given, changes by keys, and the camera. Throws
/// ViewerError.
void SaveSession(ViewerScene& scene, const ViewerOptions& options);

#endif
