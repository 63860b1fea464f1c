// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SurfaceField
 * @brief   which of a mesh's arrays are the vectors that a filter has been asked for
 *
 * Private to the module's own sources.
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
  /// Why there are no vectors, as what the input lacks.
  std::string Error;
};

/**
 * `inputArray` is an algorithm's information of an input array. By its attribute, and not by a
 * name, an array that cannot be the vectors gives way to the first one that can.
 */
SurfaceField FindSurfaceField(vtkPolyData* mesh, vtkInformation* inputArray);
}

#endif
