// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReadingGuard
 * @brief   ends the program with one line if a damaged file makes its reader crash or hang
 *
 * The readers of VTK and of the libraries below it trust their files. While an object of this class
 * exists, these end the program with exit code 1 and a line that names the file: a crash, an
 * uncaught exception, a call of exit(), and no progress for a time. Memory is limited to what the
 * machine has left, so that a file that asks for more gets std::bad_alloc.
 *
 * Signal handlers do this in the program itself. A child process could do no more for the user, but
 * would have to read each file a second time, or copy what it has read to its parent. It would also
 * have to be a new program: some libraries that VTK loads start threads at once, and a fork without
 * them hangs when it ends.
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

/// From here on a crash ends the program with exit code 1 and a line that names the input, too.
void InstallCrashHandlers(const std::string& input);

class ReadingGuard
{
public:
  /// While these are read. Guards are not nested.
  explicit ReadingGuard(const std::vector<std::string>& fileNames);
  ~ReadingGuard();
  ReadingGuard(const ReadingGuard&) = delete;
  void operator=(const ReadingGuard&) = delete;

  /// Another algorithm starts.
  static void RestartProgress();

  /// A share in [0, 1] of its work: one that is larger than before is a sign of life.
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
