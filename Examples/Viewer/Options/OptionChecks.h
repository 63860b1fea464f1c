// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which options go together
 */
#ifndef OptionChecks_h
#define OptionChecks_h

#include <map>
#include <string>

struct ViewerOptions;

/// Throws UsageError where options that were given, with their values, do not go together; reads
/// those whose values depend on others.
void CheckOptions(ViewerOptions& options, const std::map<std::string, std::string>& given);

#endif
