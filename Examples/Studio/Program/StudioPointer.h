// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StudioPointer
 * @brief   the mouse over the scene, and the keys of relevo-view
 *
 * The values under the mouse follow it and the view after a short time, so that a stream of events
 * does not wait for them.
 */
#ifndef StudioPointer_h
#define StudioPointer_h

#include "Drawing/SceneProbe.h"

#include "vtkNew.h"

#include <optional>

class Studio;
class vtkCallbackCommand;
class vtkRenderWindowInteractor;

class StudioPointer
{
public:
  /// Without timers, values are found by Update() only. Must live until the interactor has ended.
  StudioPointer(Studio& studio, vtkRenderWindowInteractor* interactor, bool hasTimers);
  ~StudioPointer();

  /// Shows the values under the mouse now.
  void Update();

private:
  void OnMove(bool isInside);
  void OnPress();
  void OnRelease();
  void OnFrame();
  void OnTimer(int timer);
  void StartTimer();
  /// Returns whether the key is one of the studio.
  bool OnCharacter();
  std::optional<WindowPixel> FindPixel() const;

  Studio& Driven;
  vtkRenderWindowInteractor* Interactor;
  vtkNew<vtkCallbackCommand> KeyCommand;
  bool HasTimers;
  int Timer = 0; // 0 for none
  bool IsInside = false;
  std::optional<WindowPixel> Pressed; // over the scene
  long long RepeatedFrames = 0;
};

#endif
