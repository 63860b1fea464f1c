// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   names of numbered pictures, such as "frames/%04d.png"
 */
#ifndef FramePattern_h
#define FramePattern_h

#include <cstddef>
#include <string>

/// Whether a name has a number such as %04d in its last part, once, and no other percent signs.
bool IsFramePattern(const std::string& name);

/// "frames/%04d.png", 7 -> "frames/0007.png"
std::string MakeFrameName(const std::string& pattern, std::size_t number);

#endif
