// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   parses the command line
 */
#ifndef OptionParser_h
#define OptionParser_h

#include "Options/ViewerOptions.h"

#include <string>

/// Returns the options of the command line. Throws UsageError.
ViewerOptions ParseOptions(int argc, char* argv[]);

/// Whether there is an option of this name, which begins with --.
bool HasOption(const std::string& name);

#endif
