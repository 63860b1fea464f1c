// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the surface of the options
 */
#ifndef ViewerSurface_h
#define ViewerSurface_h

#include "vtkSmartPointer.h"

class vtkRefinementSurface;
struct ViewerOptions;

/// For a mesh whose bounding box has this diagonal.
vtkSmartPointer<vtkRefinementSurface> MakeSurface(const ViewerOptions& options, double diagonal);

/// Sets the numbers of the options on an existing surface.
void UpdateSurface(const ViewerOptions& options, double diagonal, vtkRefinementSurface* surface);

#endif
