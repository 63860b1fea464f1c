// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   draws patterns and their histogram by ImGui
 */
#ifndef PatternDrawing_h
#define PatternDrawing_h

#include "Scene/SceneContent.h"

#include <string>
#include <vector>

class EdgePattern;

/// The triangles of a pattern, its edges with their levels, and its numbers.
void DrawPattern(const EdgePattern& pattern);

/// Bars for the triangles of each level, and for the faces of each pattern. The level of a face is
/// that of its finest edge.
void DrawHistogram(const std::vector<PatternCount>& counts);

/// The name of a pattern: its levels such as "[3, 2, 0]", or numbers of segments such as "5-3-2".
std::string NamePattern(const std::array<int, 3>& segments);

/// The numbers of a histogram as figures: "level-3-triangles" and "faces-8-4-1".
SceneFigures ListCounts(const std::vector<PatternCount>& counts);

#endif
