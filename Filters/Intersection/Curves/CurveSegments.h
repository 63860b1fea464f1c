// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveSegments
 * @brief   the points, segments and polygons that two surfaces have in common, each of them once
 *
 * What several pairs of triangles have in common is taken of the first of them. Segments with
 * polygons on both sides, and points at the end of a segment or at the corner of a polygon, are
 * parts of these, and left out.
 *
 * Private to the module's own sources.
 */
#ifndef CurveSegments_h
#define CurveSegments_h

#include "Pairs/PairSearch.h"
#include "vtkType.h" // for vtkIdType

#include <array>  // for members
#include <vector> // for members

namespace relevo
{
class IntersectionPoints;

struct CurveSegments
{
  CurveSegments(const std::vector<IntersectingPair>& pairs, const IntersectionPoints& points);

  struct Touch
  {
    vtkIdType Point;
    std::size_t Pair;
  };
  struct Segment
  {
    std::array<vtkIdType, 2> Points;
    std::size_t Pair;
  };

  std::vector<Touch> Touches;
  std::vector<Segment> Segments;
  std::vector<std::size_t> Overlaps; // pairs whose triangles have a polygon in common
};
}

#endif
