// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureAhead
 * @brief   predicts the view of the next capture, and whether a capture saves time
 *
 * A view that rotates by a few degrees from frame to frame leaves each capture at once. A capture
 * one frame ahead of the motion serves this frame, which lies between two captures, and the next
 * one. If even such captures serve a single frame, frames are drawn without captures for a while.
 * Private to the module.
 */
#ifndef CaptureAhead_h
#define CaptureAhead_h

#include "Mathematics/RefinementMathematics.h"

class vtkCamera;

namespace relevo
{
class CaptureAhead
{
public:
  /// Set the camera of the current frame; frames follow one another.
  void MoveTo(vtkCamera* camera);
  /// Stop the motion.
  void Stop() { this->NumberOfFrames = 0; }

  /// Move a camera by the motion between the last two frames, to the expected view of the next one.
  /// Return whether there is any motion.
  bool Advance(vtkCamera* camera) const;

  /// Return whether a capture may be made in this frame, which needs one.
  bool IsWorthwhile();
  /// Record a capture.
  void AddCapture() { this->NumberOfShownFrames = 0; }
  /// Record a frame that shows captures.
  void AddShownFrame() { ++this->NumberOfShownFrames; }

private:
  dmat4 FromView = dmat4(1.0); // view of the last frame
  dmat4 Motion = dmat4(1.0);   // in world coordinates, between the last two frames
  int NumberOfFrames = 0;      // at most 2
  int NumberOfShownFrames = 2; // since the last capture
  int NumberOfLosses = 0;      // successive captures that served fewer than two frames
  int Pause = 0;               // frames without captures after the last losses
  int FramesLeft = 0;          // frames left of the pause
};
}

#endif
