// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkVolumeWay.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"

#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridLinearRayIntegrator.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkVolume.h"

namespace
{
vtkSmartPointer<vtkUnstructuredGridVolumeMapper> MakeRelevo(VolumeWay way)
{
  auto mapper = vtkSmartPointer<vtkGPUUnstructuredGridVolumeMapper>::New();
  if (way == VolumeWay::PreIntegrated)
  {
    mapper->SetIntegrationToPreIntegrated();
  }
  else if (way == VolumeWay::Projection)
  {
    mapper->SetMethodToCellProjection();
  }
  return mapper;
}

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> MakeRayCast(VolumeWay way)
{
  auto mapper = vtkSmartPointer<vtkUnstructuredGridVolumeRayCastMapper>::New();
  // One ray per pixel.
  mapper->AutoAdjustSampleDistancesOff();
  if (way == VolumeWay::VTKLinear)
  {
    vtkNew<vtkUnstructuredGridLinearRayIntegrator> integrator;
    mapper->SetRayIntegrator(integrator);
  }
  return mapper;
}
}

const char* GetName(VolumeWay way)
{
  switch (way)
  {
    case VolumeWay::Exact:
      return "ray casting, exact";
    case VolumeWay::PreIntegrated:
      return "ray casting, pre-integrated";
    case VolumeWay::Projection:
      return "cell projection with its sort";
    case VolumeWay::VTKLinear:
      return "VTK's ray casting, linear integrator";
    case VolumeWay::VTKDefault:
      return "VTK's ray casting, default integrator";
    case VolumeWay::VTKProjected:
      break;
  }
  return "vtkProjectedTetrahedraMapper";
}

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> MakeVolumeMapper(VolumeWay way)
{
  switch (way)
  {
    case VolumeWay::VTKLinear:
    case VolumeWay::VTKDefault:
      return MakeRayCast(way);
    case VolumeWay::VTKProjected:
      return vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
    default:
      return MakeRelevo(way);
  }
}

vtkSmartPointer<vtkVolume> MakeVolume(
  VolumeWay way, vtkUnstructuredGrid* mesh, vtkVolumeProperty* property)
{
  const auto mapper = MakeVolumeMapper(way);
  mapper->SetInputData(mesh);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  return volume;
}
