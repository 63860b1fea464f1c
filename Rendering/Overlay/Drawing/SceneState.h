// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the picture of a window depends on, to find out whether it is out of date
 */
#ifndef SceneState_h
#define SceneState_h

#include "Changes/Dependencies.h"

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace relevo
{
/**
 * Return the dependencies of all renderers of a window except one: their cameras, lights, props and
 * the pipelines of their mappers, and the window's buffers.
 */
Dependencies FindSceneState(vtkOpenGLRenderWindow* window, vtkRenderer* other);

/**
 * Return whether the next frame may show the scene of the last one: the whole picture is drawn for
 * one eye, and no renderer selects or draws panels of another overlay.
 */
bool CanRepeatScene(vtkOpenGLRenderWindow* window, vtkRenderer* other);
}

#endif
