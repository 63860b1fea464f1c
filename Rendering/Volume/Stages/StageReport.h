// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the events that a stage has its mapper invoke
 *
 * Private to the module.
 */
#ifndef StageReport_h
#define StageReport_h

#include <string>
#include <vector>

namespace relevo
{
struct StageReport
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
}

#endif
