// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks a pattern that was read from a file
 */
#ifndef PatternCheck_h
#define PatternCheck_h

namespace relevo
{
struct RefinementPattern;
/**
 * Return what is wrong with a pattern (without its lines), or nullptr if it is a conforming,
 * counter-clockwise triangulation with exactly the border points of its segments.
 */
const char* FindDefect(const RefinementPattern& pattern);
}

#endif
