// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which of several normals at one point are the same surface's
 */
#ifndef NormalGroups_h
#define NormalGroups_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

#include <vector>

namespace relevo
{
/**
 * For each normal the lowest index of its group. Two normals are in one group if a chain of normals
 * joins them in which each differs from the next by at most the tolerance (the length of the
 * difference). The groups do not depend on the order of the normals. Normals are finite.
 */
void GroupNormals(
  const std::vector<vec3>& normals, float tolerance, std::vector<vtkIdType>& groups);
}

#endif
