// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   exit codes and messages of the programs
 */
#ifndef ProgramRun_h
#define ProgramRun_h

#include <functional>
#include <string>

/// Runs a program. Writes the message of an exception, and returns the exit code: 0 for success, 1
/// for bad input, 2 for bad usage.
int RunProgram(const std::string& name, const std::function<void()>& run);

#endif
