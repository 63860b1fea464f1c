// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds texts and lines over a picture to the program of a scene
 */
#ifndef OverlayCode_h
#define OverlayCode_h

class SceneCode;
class vtkActor2D;
class vtkTextActor;

/// Adds a text at a position in pixels, or in normalized coordinates of the viewport.
void AddTextCode(SceneCode& code, vtkTextActor* text);

/// Adds the lines of an actor in pixels. Throws ViewerError for other shapes.
void AddLineCode(SceneCode& code, vtkActor2D* actor);

#endif
