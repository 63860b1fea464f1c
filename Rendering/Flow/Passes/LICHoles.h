// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   dependencies of holes in a surface: transparent colours, where VTK draws nothing
 *
 * Other colours and opacities do not affect the streaks. Private to the module.
 */
#ifndef LICHoles_h
#define LICHoles_h

class vtkActor;
class vtkScalarsToColors;

namespace relevo
{
class Dependencies;

/// Add the lookup table and the textures with their images, if they can be transparent.
void AddHoles(Dependencies& dependencies, vtkActor* act, vtkScalarsToColors* table);
}

#endif
