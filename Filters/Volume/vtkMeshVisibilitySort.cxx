// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshVisibilitySort.h"

#include "Checks/MemoryGuard.h"
#include "Mesh/CellFaces.h"
#include "Mesh/VisibilityOrder.h"
#include "View/CameraEye.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

struct vtkMeshVisibilitySort::vtkInternals
{
  relevo::VisibilityOrder Order;
  std::vector<vtkIdType> CellIds; // ids of the cells of Order
  vtkWeakPointer<vtkDataSet> BuiltFrom;
  vtkMTimeType BuildTime = 0;

  const std::vector<int>* Sorted = nullptr;
  vtkIdType NumberOfReturned = 0;
  vtkNew<vtkIdTypeArray> NextCells;
};

namespace
{
using relevo::dvec3;

std::vector<dvec3> GetPoints(vtkDataSet* mesh)
{
  std::vector<dvec3> points(mesh->GetNumberOfPoints());
  for (size_t i = 0; i < points.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  return points;
}
}

vtkStandardNewMacro(vtkMeshVisibilitySort);

vtkMeshVisibilitySort::vtkMeshVisibilitySort()
  : Internals(new vtkInternals)
{
}

vtkMeshVisibilitySort::~vtkMeshVisibilitySort() = default;

bool vtkMeshVisibilitySort::Build()
{
  vtkInternals& internals = *this->Internals;
  if (internals.BuiltFrom == this->Input && internals.BuildTime == this->Input->GetMTime())
  {
    return true;
  }
  internals.BuiltFrom = nullptr;
  if (std::max(this->Input->GetNumberOfPoints(), this->Input->GetNumberOfCells()) > VTK_INT_MAX)
  {
    vtkErrorMacro("The input has more than " << VTK_INT_MAX << " points or cells.");
    return false;
  }
  std::vector<std::string> errors;
  relevo::CellFaces cells = relevo::ReadCellFaces(this->Input, internals.CellIds, errors);
  for (const std::string& error : errors)
  {
    vtkErrorMacro(<< error);
  }
  if (cells.Faces.size() > VTK_INT_MAX)
  {
    vtkErrorMacro("The input has cells of more than " << VTK_INT_MAX << " faces.");
    return false;
  }
  internals.Order.Build(GetPoints(this->Input), std::move(cells));
  internals.BuiltFrom = this->Input;
  internals.BuildTime = this->Input->GetMTime();
  return true;
}

void vtkMeshVisibilitySort::InitTraversal()
{
  vtkInternals& internals = *this->Internals;
  internals.Sorted = nullptr;
  internals.NumberOfReturned = 0;
  if (!this->Input || !this->Camera)
  {
    vtkErrorMacro(
      "There is no " << (this->Input ? "camera: call SetCamera()." : "input: call SetInput()."));
    return;
  }
  const auto sort = [&]
  {
    if (this->Build())
    {
      internals.Sorted =
        &internals.Order.Sort(relevo::GetEye(this->Camera, this->InverseModelTransform));
      this->LastSortTime.Modified();
    }
    return internals.Sorted != nullptr;
  };
  if (!relevo::RunWithinMemory(this, "the order of the cells", sort))
  {
    internals.Sorted = nullptr;
    internals.BuiltFrom = nullptr;
  }
}

vtkIdTypeArray* vtkMeshVisibilitySort::GetNextCells()
{
  vtkInternals& internals = *this->Internals;
  const vtkIdType size = internals.Sorted ? static_cast<vtkIdType>(internals.Sorted->size()) : 0;
  const vtkIdType begin = internals.NumberOfReturned;
  const vtkIdType end = std::min<vtkIdType>(size, begin + this->MaxCellsReturned);
  if (begin == end)
  {
    return nullptr;
  }
  internals.NextCells->SetNumberOfTuples(end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    const vtkIdType position = this->Direction == FRONT_TO_BACK ? size - 1 - i : i;
    internals.NextCells->SetValue(i - begin, internals.CellIds[(*internals.Sorted)[position]]);
  }
  internals.NumberOfReturned = end;
  return internals.NextCells;
}

vtkIdType vtkMeshVisibilitySort::GetNumberOfCycles()
{
  return this->Internals->Sorted ? this->Internals->Order.GetNumberOfCycles() : 0;
}

void vtkMeshVisibilitySort::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCycles: " << this->GetNumberOfCycles() << endl;
}
