// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   segments joined into lines that are as long as can be
 *
 * Private to the module's own sources.
 */
#ifndef JoinedLines_h
#define JoinedLines_h

#include "Curves/CurveSegments.h"

namespace relevo
{
struct JoinedLine
{
  std::vector<vtkIdType> Points; // of a closed one the first is also the last
  std::vector<std::size_t> Segments;
};

/**
 * Lines end where not just two segments meet, and where there is no such point they are closed.
 * Points are counted from 0 to `numberOfPoints`.
 */
std::vector<JoinedLine> JoinSegments(
  const std::vector<CurveSegments::Segment>& segments, vtkIdType numberOfPoints);

/**
 * For each line the connected component of the curves that it is of, counted from 0 in their order.
 */
std::vector<vtkIdType> FindComponents(
  const std::vector<JoinedLine>& lines, vtkIdType numberOfPoints);
}

#endif
