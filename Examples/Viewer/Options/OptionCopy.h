// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   copies the values of single options
 */
#ifndef OptionCopy_h
#define OptionCopy_h

#include <set>
#include <string>

struct ViewerOptions;

using OptionNames = std::set<std::string>; // with --

/// Copies the values of options that scenes can change without being built again. Ignores others.
void CopyOptions(const ViewerOptions& from, const OptionNames& names, ViewerOptions& to);

#endif
