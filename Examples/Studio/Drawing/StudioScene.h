// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StudioScene
 * @brief   the scene in a window, which follows the options
 *
 * Options that a scene can update change it in place. Others make a new scene, which replaces the
 * old one when it is complete.
 */
#ifndef StudioScene_h
#define StudioScene_h

#include "Scene/ViewerScene.h"
#include "State/OptionValues.h"
#include "Text/ViewerMessages.h"
#include "Window/SceneAdditions.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

class vtkCamera;
class vtkRenderWindow;

class StudioScene
{
public:
  /// Reads the file. With isComplete, every frame shows all details, as a picture of relevo-view
  /// does. Throws ViewerError.
  StudioScene(vtkRenderWindow* window, const OptionValues& values, bool isComplete);
  ~StudioScene();

  /// Shows other options. Throws ViewerError or UsageError; the scene is then as before.
  void Apply(const OptionValues& values);
  /// The options that are shown.
  const OptionValues& GetValues() const { return this->Values; }

  /// Reports errors of the last frame as ViewerError.
  void CheckFrame();

  ViewerScene& Get() { return *this->Scene; }
  ViewerMessages& GetMessages() { return *this->Messages; }
  /// The choices of the file, and the present light and view.
  const SceneContent& GetContent();
  /// Figures of the last frame. Builds include those of earlier scenes.
  SceneFigures GetFigures();

  /// Moves the camera back to the view of the options.
  void ResetView();

  /// Draws the scene on the left of a panel of this width in pixels, if there is room beside it.
  /// Until the user moves the camera, the view fits into this part of the window.
  void SetPanelWidth(int width);
  int GetPanelWidth() const { return this->PanelWidth; }

  /// Draws the scene in one of several columns of equal size beside the panel. Default: the only
  /// one.
  void SetColumn(int column, int number);
  /// The size of a column in pixels, and the part of the window of any column.
  const std::array<int, 2>& GetColumnSize() const { return this->Size; }
  std::array<double, 4> GetColumnViewport(int column) const;

  /// Looks through the camera of another scene, which moves it from now on.
  void ShareCamera(vtkCamera* camera);

private:
  ViewerOptions Parse(const OptionValues& values) const;
  void Build(const OptionValues& values);
  void UpdateContent();
  bool IsViewMoved() const;
  void StoreView();
  void UpdateSize();
  void ApplySize();

  vtkRenderWindow* Window;
  OptionValues Values;
  bool IsComplete;
  std::unique_ptr<ViewerMessages> Messages;
  std::unique_ptr<ViewerScene> Scene;
  std::unique_ptr<SceneAdditions> Additions; // to the scene, before which they are deleted
  SceneContent Content;
  int ContentVersion = 0;
  int PanelWidth = 0;
  int Column = 0;
  int NumberOfColumns = 1;
  std::array<int, 2> Size = { { 0,
    0 } };                            // of the scene's part of the window, after the first frame
  vtkSmartPointer<vtkCamera> OwnView; // the camera of the options
  vtkSmartPointer<vtkCamera> SharedCamera; // nullptr for the scene's own
  double EarlierBuilds[2] = { 0.0, 0.0 };  // of buffers and shaders, in scenes that were replaced
};

#endif
