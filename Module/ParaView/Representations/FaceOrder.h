// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   points and faces in an order that depends on where they lie alone
 *
 * Private to the module.
 */
#ifndef FaceOrder_h
#define FaceOrder_h

class vtkPolyData;

namespace relevo
{
/**
 * Sort the points of a mesh by their coordinates (those at one place by their texture coordinates,
 * then their normals), and its polygons by their points, which stay in their order. Other cells
 * stay where they are.
 */
void SortByPosition(vtkPolyData* mesh);
}

#endif
