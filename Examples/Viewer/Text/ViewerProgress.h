// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerProgress
 * @brief   shows progress in one line of a terminal, which is cleared at the end
 *
 * The terminal is stderr. If stderr is not a terminal, nothing is written.
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

  /// Replaces the previous line.
  void Show(const std::string& work);

  /// Shows a share of work in [0, 1], at most ten times per second.
  void Show(const std::string& work, double share);

  /// Call this before other output is written.
  void Clear();

private:
  void Write(const std::string& line);

  const bool IsTerminal;
  std::string Work;
  std::size_t Length = 0; // length of the visible line
  std::chrono::steady_clock::time_point LastTime;
};

#endif
