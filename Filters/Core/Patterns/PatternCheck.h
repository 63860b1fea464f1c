// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether a pattern is what a refined face needs
 *
 * Private to the module's own sources.
 */
#ifndef PatternCheck_h
#define PatternCheck_h

namespace relevo
{
struct RefinementPattern;
/**
 * What is wrong with a pattern that was read from a file (its lines aside), nullptr when it is a
 * conforming, counter-clockwise triangulation with exactly the border points of its segments.
 */
const char* FindDefect(const RefinementPattern& pattern);
}

#endif
