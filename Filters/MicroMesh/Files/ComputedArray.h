// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   arrays that the reader computes, as bytes
 *
 * Normals and level errors follow from the micro-mesh. Bytes have a bit for each tuple, which is
 * set where the array has other values than the computed ones, and then these tuples.
 */
#ifndef ComputedArray_h
#define ComputedArray_h

#include "Data/MicroMesh.h"
#include "vtkSmartPointer.h"

#include <string>
#include <string_view>

class vtkDataArray;
class vtkFloatArray;

namespace relevo
{
/// Compute an array of points or cells of a micro-mesh by its name. Returns nullptr for others.
vtkSmartPointer<vtkFloatArray> ComputeMicroPointData(const MicroMesh& mesh, const char* name);
vtkSmartPointer<vtkFloatArray> ComputeMicroCellData(const MicroMesh& mesh, const char* name);

/// Whether an array has the type and the numbers of components and tuples of a computed one.
bool IsLikeComputed(vtkDataArray* array, vtkFloatArray* computed);

/// Pack such an array.
std::string PackOtherTuples(vtkDataArray* array, vtkFloatArray* computed);

/// Change tuples of a computed array. Returns false if the bytes do not have the right size.
bool UnpackOtherTuples(std::string_view bytes, vtkFloatArray* computed);
}

#endif
