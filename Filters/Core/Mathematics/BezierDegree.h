// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the degrees that curves and patches may have
 *
 * Private to the modules' own sources.
 */
#ifndef BezierDegree_h
#define BezierDegree_h

namespace relevo
{
constexpr int LargestDegree = 8;
}

#endif
