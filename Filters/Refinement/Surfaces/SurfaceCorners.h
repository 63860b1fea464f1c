// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the corners of a surface's face, for the shared surface functions
 */
#ifndef SurfaceCorners_h
#define SurfaceCorners_h

#include "Mesh/FaceCorners.h"
#include "vtkRefinementSurface.h"

namespace relevo
{
using SurfaceCorners = FaceCorners<vtkRefinementSurface::Face>;
}

#endif
