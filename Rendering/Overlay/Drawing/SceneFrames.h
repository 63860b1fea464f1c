// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneFrames
 * @brief   decides whether a frame draws the scene, or repeats its last picture
 *
 * A frame repeats the scene if only the panels requested it, and if the scene has not changed since
 * the last frame. Other renderers are then not drawn.
 */
#ifndef SceneFrames_h
#define SceneFrames_h

#include "Changes/Dependencies.h"
#include "Drawing/PanelBackground.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkRenderer;
class vtkRenderWindow;

namespace relevo
{
class SceneFrames
{
public:
  /// The panels request a frame, or something else does.
  void RequestPanels() { this->HasPanelRequest = true; }
  void RequestScene() { this->HasSceneRequest = true; }

  /// Start a frame that `panels` draws over. Skip the other renderers if the scene can be repeated.
  void Start(vtkRenderWindow* window, vtkRenderer* panels, bool canRepeat);
  /// Prepare the pixels below panels that cover a rectangle, before they are drawn.
  void DrawBackground(vtkOpenGLRenderWindow* window, const PixelRectangle& rectangle);
  /// Finish a frame.
  void Finish(vtkRenderWindow* window, vtkRenderer* panels);

  /// Return whether the current frame, or the last one, repeats the scene.
  bool IsRepeating() const { return this->Repeats; }
  /// Forget the last picture of the scene.
  void Clear() { this->Background.Clear(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Background.ReleaseGraphicsResources(window);
  }

private:
  PanelBackground Background;
  Dependencies State; // of the scene in the last frame
  std::vector<vtkSmartPointer<vtkRenderer>> Skipped;
  bool HasPanelRequest = false;
  bool HasSceneRequest = false;
  bool CanStore = false; // in the current frame
  bool Repeats = false;
};
}

#endif
