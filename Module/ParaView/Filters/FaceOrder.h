// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   sorts points and faces so that their order depends on positions alone
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
 * Sort the points of a mesh by coordinates (coincident points by texture coordinates, then by
 * normals), and its polygons by their points. The order of points in a polygon, and other cells, do
 * not change.
 */
RELEVOPARAVIEWFILTERS_EXPORT void SortByPosition(vtkPolyData* mesh);
}

#endif
