// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the text of --help
 */
#ifndef StudioUsage_h
#define StudioUsage_h

#include <string>

std::string GetStudioUsage();

/// The mouse and the keys of the window.
std::string GetStudioKeys();

#endif
