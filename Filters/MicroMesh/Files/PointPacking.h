// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the points of a mesh as bytes
 *
 * A point at the same place as an earlier one is a reference, as at seams. Most other points have
 * coordinates that are integers times a power of two. These integers are stored as differences to
 * those of the point before, with the sign in the lowest bit. Bits tell which of these points are
 * stored as they are.
 */
#ifndef PointPacking_h
#define PointPacking_h

#include <string>
#include <string_view>
#include <vector>

class vtkDataArray;

namespace relevo
{
/// For each point, the first point with the same coordinates, to the bit.
std::vector<int> FindFirstPoints(vtkDataArray* points);

/// Pack an array of floats or doubles with three components.
std::string PackPoints(vtkDataArray* points, const std::vector<int>& firsts);

/// Fill an array. Returns false if the bytes do not have the right size.
bool UnpackPoints(std::string_view bytes, vtkDataArray* points);
}

#endif
