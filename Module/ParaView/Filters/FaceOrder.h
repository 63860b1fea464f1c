// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   points and faces in an order that depends on where they lie alone
 *
 * Not wrapped: for the sources of the plugin.
 */
#ifndef FaceOrder_h
#define FaceOrder_h

#include "RelevoParaViewFiltersModule.h" // for export macro

class vtkPolyData;

namespace relevo
{
/**
 * Sort the points of a mesh by their coordinates (those at one place by their texture coordinates,
 * then their normals), and its polygons by their points, which stay in their order. Other cells
 * stay where they are.
 */
RELEVOPARAVIEWFILTERS_EXPORT void SortByPosition(vtkPolyData* mesh);
}

#endif
