// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the supported degrees of curves and patches
 */
#ifndef BezierDegree_h
#define BezierDegree_h

namespace relevo
{
constexpr int LargestDegree = 8;
}

#endif
