// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SplitPoints
 * @brief   points of a refined mesh that several faces share with different normals
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
  /// The normal of a face at a point that needs a copy.
  struct Copy
  {
    vtkIdType Point;
    int Use;  // 3 * face + sorted corner or edge
    int Step; // 0 for a corner; inside an edge, from 1 at its first end
    vec3 Normal;
  };
  /// Sorted by point and use. Equal normals share a copy.
  std::vector<Copy> Copies;

  /// The use that evaluates a corner or the points inside an edge.
  struct Owner
  {
    int Element; // input point or edge
    int Use;
  };
  //@{
  /// Owners where the choice matters: matching normals can differ in their last digits.
  std::vector<Owner> PointOwners;
  std::vector<Owner> EdgeOwners;
  //@}
};
}

#endif
