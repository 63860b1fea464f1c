// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReadingGuard
 * @brief   ends the program with one line if a damaged file makes its reader crash or hang
 *
 * Readers of VTK and of other libraries trust their files. While an object of this class exists,
 * the following events end the program with exit code 1 and a line that names the file: a crash, an
 * uncaught exception, a call of exit(), and a long time without progress. Memory is limited to what
 * the machine has left, so that larger requests throw std::bad_alloc.
 *
 * Signal handlers do this in the process itself. A child process would have to read each file a
 * second time or copy its data to the parent. It would also have to be a new program, because some
 * libraries start threads when VTK loads them, and a forked process without these hangs at its end.
 */
#ifndef ReadingGuard_h
#define ReadingGuard_h

#include "Text/StandardError.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

/// From now on, a crash ends the program with exit code 1 and a line that names the input.
void InstallCrashHandlers(const std::string& input);

class ReadingGuard
{
public:
  /// Guards the reading of these files. Guards cannot be nested.
  explicit ReadingGuard(const std::vector<std::string>& fileNames);
  ~ReadingGuard();
  ReadingGuard(const ReadingGuard&) = delete;
  void operator=(const ReadingGuard&) = delete;

  /// Starts a new measurement for another algorithm.
  static void RestartProgress();

  /// Reports the share of work done, in [0, 1]. Only an increase counts as progress.
  static void ReportProgress(double share);

private:
  void LimitMemory();
  void Watch();

  std::unique_ptr<StandardErrorMute> Mute;
  std::string OldLine;
  unsigned long long OldMemoryLimit = 0;
  bool IsDone = false;
  std::mutex Mutex;
  std::condition_variable Done;
  std::thread Watcher;
};

#endif
