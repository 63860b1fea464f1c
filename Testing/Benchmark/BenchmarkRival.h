// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkRival
 * @brief   a separate program that answers each line of text with one line
 *
 * This way another version of VTK can draw in turn with this one.
 */
#ifndef BenchmarkRival_h
#define BenchmarkRival_h

#include <string>
#include <sys/types.h>
#include <vector>

class BenchmarkRival
{
public:
  /// Starts the program with its arguments. Its stderr is this program's.
  explicit BenchmarkRival(const std::vector<std::string>& command);
  /// Closes its input and waits until it ends.
  ~BenchmarkRival();
  BenchmarkRival(const BenchmarkRival&) = delete;
  void operator=(const BenchmarkRival&) = delete;

  /// The answer; empty if the program has ended.
  std::string Ask(const std::string& line);
  /// The numbers in the answer.
  std::vector<double> AskNumbers(const std::string& line);

private:
  int Socket = -1; // its standard input and output
  pid_t Process = -1;
};

#endif
