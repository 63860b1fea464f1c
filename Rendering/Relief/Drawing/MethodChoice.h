// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MethodChoice
 * @brief   measures methods in the first frames, and has the fastest draw the others
 *
 * Private to the module.
 */
#ifndef MethodChoice_h
#define MethodChoice_h

#include "Core/Dependencies.h"

#include <vector>

namespace relevo
{
class MethodChoice
{
public:
  explicit MethodChoice(const std::vector<int>& candidates);

  /// The method of a frame of so many pixels. It is measured again when what it draws is other than
  /// before, or the number of pixels is twice or half of what it was then.
  int Begin(const Dependencies& source, double pixels);
  /// When the frame's commands are given.
  void End();

  /// The fastest so far, or the first, of a frame that is not to be measured.
  int Get() const { return this->Candidates[this->Fastest]; }

private:
  static constexpr int Rounds = 3; // the first builds shaders and does not count

  const std::vector<int> Candidates;
  std::vector<double> Seconds;
  Dependencies Source;
  double Pixels = 0.0;
  int Frame = 0; // candidate Frame / Rounds is measured
  int Fastest = 0;
  double StartTime = 0.0;
};
}

#endif
