// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SplitPoints
 * @brief   points of a refined mesh that several faces share and see with different normals
 */
#ifndef SplitPoints_h
#define SplitPoints_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

#include <vector>

namespace relevo
{
struct SplitPoints
{
  /// A face's normal at a point that needs a copy there.
  struct Copy
  {
    vtkIdType Point;
    int Use;  // 3 * face + sorted corner, or edge
    int Step; // 0 for a corner; of points inside an edge 1 and on, from its first end
    vec3 Normal;
  };
  /// By point and use; equal normals share a copy.
  std::vector<Copy> Copies;

  /// Which of its uses evaluates a corner or the points inside an edge.
  struct Owner
  {
    int Element; // input point or edge
    int Use;
  };
  //@{
  /// Where it matters which one does: normals that agree can differ in their last digits.
  std::vector<Owner> PointOwners;
  std::vector<Owner> EdgeOwners;
  //@}
};
}

#endif
