// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatchSurfaceFilter.h"

#include "Cells/CellChecks.h"
#include "Cells/ControlNets.h"
#include "Coarse/CoarseMesh.h"
#include "Coarse/PatchOutput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkPatchSurfaceFilter);

vtkPatchSurfaceFilter::vtkPatchSurfaceFilter() = default;

vtkPatchSurfaceFilter::~vtkPatchSurfaceFilter() = default;

int vtkPatchSurfaceFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkPatchSurfaceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  if (input->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const relevo::CellChecks checks = relevo::CheckCells(input);
  for (const std::string& fault : checks.Faults)
  {
    vtkErrorMacro(<< fault);
  }
  relevo::ControlNets nets(
    relevo::CollectNodes(input, relevo::FindBoundaryFaces(input, checks.Uses)));
  const std::vector<relevo::dvec4> points = nets.ConvertPoints(input);
  relevo::ControlPoints homogeneous = points;
  std::transform(points.begin(), points.end(), homogeneous.begin(),
    [](const relevo::dvec4& point)
    { return relevo::dvec4(relevo::dvec3(point) * point.w, point.w); });
  const relevo::CoarseMesh mesh = relevo::BuildCoarseMesh(nets, homogeneous, input);
  relevo::StorePatches(nets, points, homogeneous, mesh, input, output);
  return 1;
}

void vtkPatchSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
