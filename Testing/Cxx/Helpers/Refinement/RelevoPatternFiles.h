// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A file of patterns that differ from the library's in the positions of inner vertices.
#ifndef RelevoPatternFiles_h
#define RelevoPatternFiles_h

#include <string>

namespace RelevoPatternFiles
{
// Inner vertices move by this much from corner 3 towards corner 2, which is less than the height of
// any triangle.
constexpr float Shift = 1.0f / 128.0f;

// Writes patterns up to a level of at most 4. Returns whether this succeeded.
bool WriteShifted(const std::string& fileName, int level);
}

#endif
