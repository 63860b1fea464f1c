// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Studio
 * @brief   a scene, its controls and the panel in a window
 */
#ifndef Studio_h
#define Studio_h

#include "Controls/ControlList.h"
#include "Drawing/SceneProbe.h"
#include "Drawing/StudioComparison.h"
#include "Drawing/StudioScene.h"
#include "Panels/ControlWidget.h"
#include "Panels/StudioPanel.h"
#include "State/EdgePattern.h"
#include "State/StudioState.h"

#include "vtkNew.h"

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkImGuiOverlay;
class vtkRenderWindow;

class Studio : public PanelRequests
{
public:
  /// See StudioScene. Throws ViewerError.
  Studio(vtkRenderWindow* window, const OptionValues& values, bool isComplete);
  ~Studio() override;

  /// Writes the layout after each frame.
  void SetLayoutFile(const std::string& fileName) { this->LayoutFile = fileName; }

  //@{
  /// The panel's requests, which Apply() shows.
  void Set(
    const std::string& name, const std::optional<std::string>& value, bool isContinued) override;
  void Press(const std::string& name) override;
  //@}

  /// Shows requested changes. Call this before a frame, outside of the panel. Errors are shown by
  /// the panel.
  void Apply();

  /// Checks a value and sets the control, or a part of it. Throws UsageError or ViewerError.
  void SetValue(const std::string& name, const std::string& value);
  /// Writes a picture (.png), a session (.json), a script (.py), the folder of a C++ source (a name
  /// that ends with /), or the mesh. Throws ViewerError.
  void Save(const std::string& fileName);

  //@{
  /// The mouse over the scene. Nothing if it is elsewhere.
  void Point(const std::optional<WindowPixel>& pixel);
  /// A click keeps the values of a point, or measures.
  void ClickScene(const WindowPixel& pixel);
  /// Handles a key of relevo-view. Returns false for other keys.
  bool HandleKey(char key);
  //@}

  /// Draws a frame.
  void Draw();

  bool IsPlaying() const { return this->IsPlayed; }
  /// Shows the next time step while the steps play.
  void ShowNextStep();

  StudioPanel& GetPanel() { return this->Panel; }
  StudioScene& GetScene() { return this->Scene; }
  vtkImGuiOverlay* GetOverlay() { return this->Overlay; }
  /// The entry of the panel. Throws ViewerError with similar names.
  const LayoutEntry& FindEntry(const std::string& name);

  /// The last error, which is then forgotten, or "".
  std::string TakeError();

private:
  /// Turns the value of a part of a control, such as light.0, into that of the control. Throws
  /// ViewerError.
  void ResolvePart(std::string& name, std::string& value);
  void ResolveClip(std::string& name, std::string& value);
  [[noreturn]] void FailUnknown(const std::string& name);
  void OnFrame();
  void OnPanel();
  void OnFrameEnd();
  void Describe();
  void UpdateControls();
  void ApplyComparison();
  SceneFigures ListFigures() const;
  SceneTexts FindTexts();
  void Do(const std::string& action);
  void DoOfFiles(const std::string& action);
  void MoveStep(int step);
  bool SetView(const std::string& name);
  void Toggle(const std::string& name, bool isOn);
  bool ChangeByKey(char key);
  void KeepValues(const WindowPixel& pixel);
  void Measure(const WindowPixel& pixel);
  void OpenSession(const std::string& fileName);
  /// Does something with the view of a window without a panel.
  void RunWithoutPanel(const std::function<void()>& work);
  void Fail(const std::string& message);
  void Tell(const std::string& note);
  void SaveScene(const std::string& fileName);
  /// Writes a session, a script or a C++ source of the last frame.
  void SaveProgram(const std::string& fileName);
  /// Draws a frame that does not appear on the screen, and uses it.
  void DrawPicture(bool hasPanels, const std::function<void()>& use);

  vtkRenderWindow* Window;
  StudioState State;
  StudioScene Scene;
  StudioComparison Comparison;
  EdgePattern Pattern; // of the generator
  ControlList Controls;
  StudioPanel Panel;
  vtkNew<vtkImGuiOverlay> Overlay;
  std::vector<std::string> Actions; // requested
  std::string Message;
  std::string Note;
  SceneProbe Probe;
  std::optional<WindowPixel> Pointer;              // over the scene
  bool IsMeasuring = false;                        // by clicks
  std::optional<std::array<double, 3>> RulerStart; // the end that is set
  bool HasKeys = false;                            // whether the keys are shown
  std::optional<SessionCamera> NewCamera;          // of a session that is opened
  std::string Error;                               // until TakeError()
  bool IsPlayed = false;
  std::string LayoutFile;
  SceneFigures Figures;               // of the last frame
  SceneFigures ShownFigures;          // in the panel, of the frame before
  std::vector<PatternCount> Patterns; // of the last frame, while the panel shows them
  std::chrono::steady_clock::time_point Start;
  double ProbeTime = 0.0; // of the values under the mouse, in milliseconds
  int Frames = 0;
};

#endif
