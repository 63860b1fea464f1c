// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a picture of tetrahedra in double precision that shares no code with the library
 *
 * Slow and simple: intersects all tetrahedra with the rays of all pixels in their bounds by planes,
 * sorts the parts of a ray by distance, and integrates each in many equal steps by the midpoint
 * rule.
 */
#ifndef BenchmarkVolumeReference_h
#define BenchmarkVolumeReference_h

#include <vector>

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

struct VolumePicture
{
  std::vector<double> RGB;     // 0 to 1, row 0 is the lowest
  std::vector<bool> IsOutline; // covered pixels next to background
};

/// `mesh` has tetrahedra with point scalars, all in front of the perspective camera.
VolumePicture MakeVolumeReference(vtkUnstructuredGrid* mesh, vtkVolumeProperty* property,
  vtkCamera* camera, int size, const double background[3]);

#endif
