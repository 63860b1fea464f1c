// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerFrames
 * @brief   draws a frame after all waiting events
 *
 * VTK draws a frame for every event that changes the view. If frames are slow, events queue up, and
 * the view lags behind the mouse and the keys. Here, all requests since the last frame share one
 * frame.
 */
#ifndef ViewerFrames_h
#define ViewerFrames_h

#include <functional>

class vtkRenderWindowInteractor;

class ViewerFrames
{
public:
  /// Replaces the interactor's Render(). beforeFrame() is called before each frame. Must live until
  /// the interactor has ended.
  explicit ViewerFrames(
    vtkRenderWindowInteractor* interactor, std::function<void()> beforeFrame = [] {});

  /// Whether a requested frame has not been drawn yet.
  bool IsPending() const { return this->Timer > 0; }
  /// Draws a requested frame now.
  void Flush();

private:
  void Draw();
  void OnRender();
  void OnTimer(int timer);
  void StartTimer();

  vtkRenderWindowInteractor* Interactor;
  std::function<void()> BeforeFrame;
  int Timer = 0;    // the interactor's timer; 0 for none
  int Requests = 0; // since the last frame
  int Handled = 0;  // number of requests when the timer was started
  int Delays = 0;   // since the last frame
};

#endif
