// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureAhead
 * @brief   where the next capture is best made, and whether one is worth its time
 *
 * A view that turns by a few degrees from frame to frame leaves each capture at once. Captures that
 * are a frame ahead of the motion serve this frame, between two captures, and the next one. Where
 * even these are of use for one frame alone, frames are drawn without captures for a while. Private
 * to the module.
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
  /// Of the frame that is drawn now; frames follow one another.
  void MoveTo(vtkCamera* camera);
  /// Where the view stands still.
  void Stop() { this->NumberOfFrames = 0; }

  /// Moves a camera as far as the last two frames' views are apart: from the last one to where the
  /// next one is expected. Whether it moves.
  bool Advance(vtkCamera* camera) const;

  /// Whether a capture may be made in this frame, which needs one.
  bool IsWorthwhile();
  /// A capture was made.
  void AddCapture() { this->NumberOfShownFrames = 0; }
  /// The frame shows captures.
  void AddShownFrame() { ++this->NumberOfShownFrames; }

private:
  dmat4 FromView = dmat4(1.0); // of the last frame
  dmat4 Motion = dmat4(1.0);   // in the world, since the one before
  int NumberOfFrames = 0;      // up to 2
  int NumberOfShownFrames = 2; // since the last capture
  int NumberOfLosses = 0;      // captures in a row that fewer than two frames showed
  int Pause = 0;               // frames without captures after the last losses
  int FramesLeft = 0;          // of the pause
};
}

#endif
