// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerFrames
 * @brief   draws a frame when the events that wait have been handled
 *
 * VTK draws a frame for every event that changes the view. If frames take long, events queue up:
 * the view lags behind the mouse, and so do keys. Here all requests since the last frame share one.
 */
#ifndef ViewerFrames_h
#define ViewerFrames_h

class vtkRenderWindowInteractor;

class ViewerFrames
{
public:
  /// Takes over the interactor's Render(). Is there until the interactor has ended.
  explicit ViewerFrames(vtkRenderWindowInteractor* interactor);

  /// Whether a frame was requested and not drawn yet.
  bool IsPending() const { return this->Timer > 0; }
  /// Draws it.
  void Flush();

private:
  void Draw();
  void OnRender();
  void OnTimer(int timer);
  void StartTimer();

  vtkRenderWindowInteractor* Interactor;
  int Timer = 0;    // of the interactor; 0 for none
  int Requests = 0; // since the last frame
  int Handled = 0;  // requests when the timer was started
  int Delays = 0;   // since the last frame
};

#endif
