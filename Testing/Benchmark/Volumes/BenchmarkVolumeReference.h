// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a picture of tetrahedra in double precision, that shares nothing with the project
 *
 * Slow and simple: all tetrahedra against the rays of all pixels of their bounds, by planes; parts
 * of a ray by their distance; each in many even steps, whose middles count.
 */
#ifndef BenchmarkVolumeReference_h
#define BenchmarkVolumeReference_h

#include <vector>

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

struct VolumePicture
{
  std::vector<double> RGB;     // 0 to 1, row 0 the lowest
  std::vector<bool> IsOutline; // pixels with mesh next to ones without
};

/// `mesh`: tetrahedra with scalars of points, all in front of the camera, which is in perspective.
VolumePicture MakeVolumeReference(vtkUnstructuredGrid* mesh, vtkVolumeProperty* property,
  vtkCamera* camera, int size, const double background[3]);

#endif
