// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatchSurfaceFilter.h"

#include "Cells/CellChecks.h"
#include "Cells/ControlNets.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Coarse/CoarseMeshBuilder.h"
#include "Coarse/PatchOutput.h"
#include "Mesh/PatchArrays.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkPatchSurfaceFilter);

namespace
{
relevo::ControlPoints GetHomogeneous(const std::vector<relevo::dvec4>& points)
{
  relevo::ControlPoints homogeneous = points;
  for (relevo::dvec4& point : homogeneous)
  {
    point = relevo::dvec4(relevo::dvec3(point) * point.w, point.w);
  }
  return homogeneous;
}

std::vector<unsigned char> FindPatchesWithArea(
  const relevo::ControlNets& nets, const relevo::ControlPoints& homogeneous)
{
  const auto number = static_cast<vtkIdType>(nets.GetPatches().size());
  std::vector<unsigned char> hasArea(number);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        hasArea[i] = relevo::HasArea(nets.GetPatches()[i], homogeneous);
      }
    });
  return hasArea;
}
}

vtkPatchSurfaceFilter::vtkPatchSurfaceFilter() = default;

vtkPatchSurfaceFilter::~vtkPatchSurfaceFilter() = default;

int vtkPatchSurfaceFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkPatchSurfaceFilter::WarnOfShortArray(const std::string& name)
{
  vtkWarningMacro("Array \"" << name << "\" has too few tuples and is left out.");
}

void vtkPatchSurfaceFilter::RemoveShortArrays(vtkUnstructuredGrid* grid)
{
  vtkPointData* data = grid->GetPointData();
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < grid->GetNumberOfPoints())
    {
      this->WarnOfShortArray(array->GetName() ? array->GetName() : "");
      data->RemoveArray(i);
    }
  }
}

int vtkPatchSurfaceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the patches of the grid",
    [&]
    {
      return this->Convert(
        vtkUnstructuredGrid::GetData(inputVector[0]), vtkPolyData::GetData(outputVector));
    });
}

int vtkPatchSurfaceFilter::Convert(vtkUnstructuredGrid* input, vtkPolyData* output)
{
  relevo::PatchArrays::Remove(output); // they come from the field data of the input
  if (input->GetNumberOfCells() < 1)
  {
    return 1;
  }
  const relevo::CellChecks checks = relevo::CheckCells(input);
  for (const std::string& error : checks.Errors)
  {
    vtkErrorMacro(<< error);
  }
  if (!input->GetPoints())
  {
    return 1;
  }
  relevo::ControlNets nets(
    relevo::CollectNodes(input, relevo::FindBoundaryFaces(input, checks.Uses)));
  std::vector<relevo::dvec4> points = nets.ConvertPoints(input);
  relevo::ControlPoints homogeneous = GetHomogeneous(points);
  const std::vector<unsigned char> isKept = FindPatchesWithArea(nets, homogeneous);
  const auto degenerate = std::count(isKept.begin(), isKept.end(), 0);
  if (degenerate > 0)
  {
    vtkWarningMacro(<< degenerate << " degenerate patches without any area are left out.");
    nets.Keep(isKept);
    points = nets.ConvertPoints(input);
    homogeneous = GetHomogeneous(points);
  }
  vtkNew<vtkUnstructuredGrid> whole;
  whole->ShallowCopy(input);
  this->RemoveShortArrays(whole);
  const int minimumPieces = this->SplitPatches ? 2 : 1;
  const relevo::CoarseMesh mesh =
    relevo::BuildCoarseMesh(nets, points, homogeneous, input, minimumPieces);
  for (const std::string& name :
    relevo::StorePatches(nets, points, homogeneous, mesh, whole, output))
  {
    this->WarnOfShortArray(name);
  }
  return 1;
}

void vtkPatchSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitPatches: " << (this->SplitPatches ? "On\n" : "Off\n");
}
