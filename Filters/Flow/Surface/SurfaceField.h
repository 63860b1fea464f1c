// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SurfaceField
 * @brief   selection of the vector array of a mesh
 *
 * Private to the module.
 */
#ifndef SurfaceField_h
#define SurfaceField_h

#include <string>

class vtkDataArray;
class vtkInformation;
class vtkPolyData;

namespace relevo
{
struct SurfaceField
{
  vtkDataArray* Vectors = nullptr;
  bool IsCellData = false;
  /// The reason why there are no vectors, as the noun that is missing.
  std::string Error;
};

/**
 * `inputArray` is the input array information of an algorithm. If it selects an attribute whose
 * array cannot be vectors, the first suitable array is used. If it selects a name, no other array
 * is used.
 */
SurfaceField FindSurfaceField(vtkPolyData* mesh, vtkInformation* inputArray);
}

#endif
