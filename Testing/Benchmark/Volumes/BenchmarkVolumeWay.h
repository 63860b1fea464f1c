// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Relevo's and VTK's ways to draw a volume of cells
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
  VTKDefault, // may crash, so it needs a separate process
  VTKProjected
};

const char* GetName(VolumeWay way);

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> MakeVolumeMapper(VolumeWay way);

vtkSmartPointer<vtkVolume> MakeVolume(
  VolumeWay way, vtkUnstructuredGrid* mesh, vtkVolumeProperty* property);

#endif
