// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EventPace
 * @brief   shortens the time for frames while an interactor's events wait for them
 *
 * If a frame of a moving view begins as soon as the previous one has ended, its event has waited.
 * The time for the next frames is then halved, until events no longer wait. Private to the module.
 */
#ifndef EventPace_h
#define EventPace_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "vtkRenderWindow.h"             // for the weak pointer
#include "vtkWeakPointer.h"              // for the window

namespace relevo
{
class RELEVORENDERINGVOLUME_EXPORT EventPace
{
public:
  EventPace() = default;
  ~EventPace() { this->SetWindow(nullptr); }
  EventPace(const EventPace&) = delete;
  void operator=(const EventPace&) = delete;

  /// Observe the frames of a window; nullptr for none.
  void SetWindow(vtkRenderWindow* window);

  //@{
  /// Tell that a frame begins or has ended at a time in seconds. The window calls these.
  void Begin(bool isMoving, double time);
  void End(bool isMoving, double time);
  //@}

  /// Return the factor for the time of a frame, from 1/64 to 1.
  double GetFactor() const { return this->Factor; }

private:
  void OnStart();
  void OnEnd();

  vtkWeakPointer<vtkRenderWindow> Window;
  unsigned long Tags[2] = { 0, 0 };
  double EndTime = 0.0; // of the last frame of a moving view, in seconds
  double Factor = 1.0;
};
}

#endif
