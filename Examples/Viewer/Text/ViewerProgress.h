// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerProgress
 * @brief   how far work is, in one line of a terminal that is gone in the end
 *
 * The terminal is stderr; where that is none, nothing is written.
 */
#ifndef ViewerProgress_h
#define ViewerProgress_h

#include <chrono>
#include <string>

class ViewerProgress
{
public:
  ViewerProgress();
  ~ViewerProgress();

  /// In place of the line before.
  void Show(const std::string& work);

  /// With a share in [0, 1] of the work; ten times a second is often enough.
  void Show(const std::string& work, double share);

  /// Before anything else is written.
  void Clear();

private:
  void Write(const std::string& line);

  const bool IsTerminal;
  std::string Work;
  std::size_t Length = 0; // of the line that is seen
  std::chrono::steady_clock::time_point LastTime;
};

#endif
