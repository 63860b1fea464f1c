// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   ways to draw a volume of cells: Relevo's and VTK's
 */
#ifndef BenchmarkVolumeWay_h
#define BenchmarkVolumeWay_h

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;
class vtkUnstructuredGridVolumeMapper;
class vtkVolume;
class vtkVolumeProperty;

enum class VolumeWay
{
  Exact,
  PreIntegrated,
  Projection,
  VTKLinear,
  VTKDefault, // may crash: for a process of its own
  VTKProjected
};

const char* GetName(VolumeWay way);

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> MakeVolumeMapper(VolumeWay way);

vtkSmartPointer<vtkVolume> MakeVolume(
  VolumeWay way, vtkUnstructuredGrid* mesh, vtkVolumeProperty* property);

#endif
