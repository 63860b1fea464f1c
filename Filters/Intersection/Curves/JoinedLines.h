// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   joining of segments to lines of maximum length
 *
 * Private to the module.
 */
#ifndef JoinedLines_h
#define JoinedLines_h

#include "Curves/CurveSegments.h"

namespace relevo
{
struct JoinedLine
{
  std::vector<vtkIdType> Points; // for a closed line, the last point is the first
  std::vector<std::size_t> Segments;
};

/**
 * Lines end at points that do not have exactly two segments. Lines without such a point are closed.
 * Point ids are less than `numberOfPoints`.
 */
std::vector<JoinedLine> JoinSegments(
  const std::vector<CurveSegments::Segment>& segments, vtkIdType numberOfPoints);

/**
 * Returns for each line the index of its connected component, numbered from 0 in the order of the
 * lines.
 */
std::vector<vtkIdType> FindComponents(
  const std::vector<JoinedLine>& lines, vtkIdType numberOfPoints);
}

#endif
