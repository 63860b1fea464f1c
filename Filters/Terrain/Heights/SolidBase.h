// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   closes the mesh of a terrain with walls and a bottom
 *
 * Private to the module.
 */
#ifndef SolidBase_h
#define SolidBase_h

#include <array>
#include <functional>

class vtkPolyData;

namespace relevo
{
/**
 * Add vertical walls at all borders of a mesh of triangles, also those of holes, and a bottom.
 * `toBase` returns the point of the bottom below a point. The triangles are counter-clockwise seen
 * from above. Each edge of the result has two triangles, so points where parts of the mesh touch
 * each other are duplicated. New points have the data of the points above them, except that their
 * "Height" is `height`.
 *
 * With `mergesPoints`, points at the same position count as one, so that there are no walls between
 * the two sides of a seam.
 */
void AddSolidBase(const std::function<std::array<double, 3>(const std::array<double, 3>&)>& toBase,
  double height, bool mergesPoints, vtkPolyData* mesh);
}

#endif
