// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A file of patterns that are not those of the library: their inner vertices stand elsewhere.
#ifndef RelevoPatternFiles_h
#define RelevoPatternFiles_h

#include <string>

namespace RelevoPatternFiles
{
// How far inner vertices are moved, from corner 3 to corner 2: less than any triangle is high.
constexpr float Shift = 1.0f / 128.0f;

// Patterns up to a level, at most 4. Returns whether the file could be written.
bool WriteShifted(const std::string& fileName, int level);
}

#endif
