// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what leaves holes in a surface: colours that are clear, where VTK draws nothing
 *
 * Other colours and opacities do not matter to the streaks. Private to the module.
 */
#ifndef LICHoles_h
#define LICHoles_h

class vtkActor;
class vtkScalarsToColors;

namespace relevo
{
class Dependencies;

/// Add the table of colours, and the textures with their images, as far as they can be clear.
void AddHoles(Dependencies& dependencies, vtkActor* act, vtkScalarsToColors* table);
}

#endif
