// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reads the arguments of the command line
 */
#ifndef OptionParser_h
#define OptionParser_h

#include "Options/ViewerOptions.h"

/// Return the options that the arguments give. Throws UsageError.
ViewerOptions ParseOptions(int argc, char* argv[]);

#endif
