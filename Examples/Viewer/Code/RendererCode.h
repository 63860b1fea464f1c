// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds a renderer with its window, lights and camera to the program of a scene
 */
#ifndef RendererCode_h
#define RendererCode_h

#include <array>
#include <functional>

class SceneCode;
class vtkProp;
class vtkRenderer;

/// Adds everything in the renderer. The function adds props that only the scene knows, and returns
/// false for the others. Throws ViewerError if there is something that a program cannot have.
void AddRendererCode(SceneCode& code, vtkRenderer* renderer, const std::array<int, 2>& size,
  const std::function<bool(vtkProp*)>& addOwn);

/// Adds the camera, one frame and the picture. This ends the program.
void AddPictureCode(SceneCode& code, vtkRenderer* renderer);

#endif
