// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the triangles of a nested pattern
 *
 * See NestedPattern.
 */
#ifndef NestedPatternMesh_h
#define NestedPatternMesh_h

#include "Patterns/PatternMesh.h"

#include <array>

namespace relevo
{
/**
 * Return the nested pattern for the levels of the edges 01, 12 and 02, each in [0, 7].
 */
PatternMesh MakeNestedMesh(const std::array<int, 3>& levels);
}

#endif
