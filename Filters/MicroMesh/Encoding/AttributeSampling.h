// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   samples the point arrays of the input on the grids of a micro-mesh
 */
#ifndef AttributeSampling_h
#define AttributeSampling_h

#include "Dense/DenseMesh.h"
#include "Encoding/MicroMeshEncoder.h"

class vtkPolyData;

namespace relevo
{
/**
 * Add a field array for each numeric point array of the input, except normals and ids; see
 * MicroMeshArrays.h. The value at a grid point is that of the nearest point of the input, and at
 * corners that of the corner. On seams, a face takes the values of its own side.
 */
void SampleAttributes(
  const DenseMesh& dense, const EncodedMesh& encoded, vtkPolyData* input, vtkPolyData* output);
}

#endif
