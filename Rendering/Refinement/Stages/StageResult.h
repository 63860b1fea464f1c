// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  StageResult
 * @brief   what a stage of a mapper gives: whether the frame can go on, and what to report
 *
 * Private to the module.
 */
#ifndef StageResult_h
#define StageResult_h

#include <string>
#include <vector>

namespace relevo
{
struct StageResult
{
  bool IsValid = true;
  /// Messages that have not been reported yet.
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
}

#endif
