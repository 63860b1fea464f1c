// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds the names that a mistyped one may mean
 */
#ifndef NearNames_h
#define NearNames_h

#include <string>
#include <vector>

/// The nearest names, at most three. Empty if none is near.
std::vector<std::string> FindNearNames(
  const std::string& name, const std::vector<std::string>& names);

#endif
