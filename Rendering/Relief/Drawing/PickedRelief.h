// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the surface of a relief as VTK's pickers can intersect it
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

/// Points and cells have the ids of the image's; cells where the surface is open are blank.
vtkSmartPointer<vtkStructuredGrid> MakePickedRelief(const Relief& relief, double maximumStretch);
}

#endif
