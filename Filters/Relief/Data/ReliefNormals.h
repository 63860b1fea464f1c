// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   normals of a relief, from its depths
 *
 * Private to the modules' own sources.
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
 * Unit normals in the world, on the viewer's side: by central differences in texel space, where
 * planes are linear, so that those of planes are exact; by the one difference there is beside an
 * open side, of single texels towards the viewer. 0 where nothing was seen.
 */
RELEVOFILTERSRELIEF_EXPORT vtkSmartPointer<vtkFloatArray> ComputeReliefNormals(
  const Relief& relief);
}

#endif
