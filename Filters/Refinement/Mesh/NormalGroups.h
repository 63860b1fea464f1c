// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   groups the normals at one point that belong to the same smooth surface
 */
#ifndef NormalGroups_h
#define NormalGroups_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

#include <vector>

namespace relevo
{
/**
 * Return for each normal the lowest index of its group. Two normals belong to one group if a chain
 * of normals connects them, where neighbours differ by at most the tolerance (the length of the
 * difference). The groups do not depend on the order of the normals. Normals must be finite.
 */
void GroupNormals(
  const std::vector<vec3>& normals, float tolerance, std::vector<vtkIdType>& groups);
}

#endif
