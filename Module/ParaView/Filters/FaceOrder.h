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
#include "vtkType.h"                     // for vtkIdType

class vtkPolyData;

namespace relevo
{
/**
 * Sort the points of a mesh by coordinates (coincident points by texture coordinates, then by
 * normals and other arrays), and its polygons by their points. The order of points in a polygon,
 * and other cells, do not change.
 *
 * The points from `numberOfOwnPoints` on are those of ghosts. A ghost's point that equals another
 * point in coordinates and data is merged into it, so that pieces share points as the whole surface
 * does.
 */
RELEVOPARAVIEWFILTERS_EXPORT void SortByPosition(vtkPolyData* mesh, vtkIdType numberOfOwnPoints);

/// Sort a mesh whose points are all its own: no points are merged.
RELEVOPARAVIEWFILTERS_EXPORT void SortByPosition(vtkPolyData* mesh);
}

#endif
