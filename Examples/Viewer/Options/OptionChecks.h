// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   checks which options can be combined
 */
#ifndef OptionChecks_h
#define OptionChecks_h

#include <map>
#include <string>

struct ViewerOptions;

/// Throws UsageError if the given options, with their values, cannot be combined. Reads options
/// whose values depend on others.
void CheckOptions(ViewerOptions& options, const std::map<std::string, std::string>& given);

#endif
