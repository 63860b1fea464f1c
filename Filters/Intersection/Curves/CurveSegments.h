// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveSegments
 * @brief   points, segments and polygons of the intersection of two surfaces, without duplicates
 *
 * If several pairs of triangles have the same intersection, the first pair is used. Segments with
 * polygons on both sides, and points at the end of a segment or the corner of a polygon, are
 * omitted.
 *
 * Private to the module.
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
  std::vector<std::size_t> Overlaps; // pairs of triangles that intersect in a polygon
};
}

#endif
