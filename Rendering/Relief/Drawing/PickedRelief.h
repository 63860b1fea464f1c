// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the surface of a relief for VTK's pickers
 *
 * Private to the module.
 */
#ifndef PickedRelief_h
#define PickedRelief_h

#include "vtkSmartPointer.h"

class vtkStructuredGrid;

namespace relevo
{
class Relief;

/// Return the surface. Points and cells have the ids of the image; cells where the surface is open
/// are blanked.
vtkSmartPointer<vtkStructuredGrid> MakePickedRelief(const Relief& relief, double maximumStretch);
}

#endif
