// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   computation of normals from the depths of a relief
 *
 * Private to the modules.
 */
#ifndef ReliefNormals_h
#define ReliefNormals_h

#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkSmartPointer.h"

class vtkFloatArray;

namespace relevo
{
class Relief;

/**
 * Computes unit normals in world coordinates, on the viewer's side. Central differences in texel
 * space, where planes are linear, are exact for planes. Beside an open side, one-sided differences
 * are used. Normals of isolated texels point to the viewer. Texels without surface have 0.
 */
RELEVOFILTERSRELIEF_EXPORT vtkSmartPointer<vtkFloatArray> ComputeReliefNormals(
  const Relief& relief);
}

#endif
