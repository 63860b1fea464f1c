// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkRival
 * @brief   a program of its own that is asked line by line, and answers each with one line
 *
 * So another version of VTK can draw in turn with this one.
 */
#ifndef BenchmarkRival_h
#define BenchmarkRival_h

#include <string>
#include <sys/types.h>
#include <vector>

class BenchmarkRival
{
public:
  /// The program and its arguments; what it writes on stderr goes to this program's.
  explicit BenchmarkRival(const std::vector<std::string>& command);
  /// Closes its input and waits until it has ended.
  ~BenchmarkRival();
  BenchmarkRival(const BenchmarkRival&) = delete;
  void operator=(const BenchmarkRival&) = delete;

  /// The answer; empty when the program does not run any more.
  std::string Ask(const std::string& line);
  /// The numbers of the answer.
  std::vector<double> AskNumbers(const std::string& line);

private:
  int Socket = -1; // its standard input and output
  pid_t Process = -1;
};

#endif
