// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the output of vtkMicroMeshFilter
 */
#ifndef MicroMeshOutput_h
#define MicroMeshOutput_h

#include "Dense/DenseMesh.h"
#include "Encoding/MicroMeshEncoder.h"

class vtkPolyData;

namespace relevo
{
/**
 * Fill the output from the input and its encoded mesh. Points are split where those of the input
 * are, and where normals differ at sharp edges. Arrays of the input must have enough tuples.
 */
void StoreEncodedMesh(
  const DenseMesh& dense, const EncodedMesh& encoded, vtkPolyData* input, vtkPolyData* output);
}

#endif
