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

class vtkPolyData;

namespace relevo
{
/**
 * Add vertical walls at all borders of a mesh of triangles, also those of holes, and a bottom at
 * z = `z`. The triangles are counter-clockwise seen from above. Each edge of the result has two
 * triangles, so points where parts of the mesh touch each other are duplicated. New points have the
 * data of the points above them, except that their "Height" is `height`.
 */
void AddSolidBase(double z, double height, vtkPolyData* mesh);
}

#endif
