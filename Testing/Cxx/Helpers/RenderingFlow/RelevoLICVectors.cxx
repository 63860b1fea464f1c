// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoLICVectors.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"

namespace RelevoLICVectors
{
std::array<double, 3> Screw(const double* p)
{
  return { { -p[1] + 0.3 * p[2], p[0], 1.0 - 0.3 * p[0] } };
}

void AddVectors(vtkPolyData* mesh, const Field& field, const char* name)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName(name);
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    vectors->InsertNextTuple(field(p).data());
  }
  mesh->GetPointData()->AddArray(vectors);
  mesh->GetPointData()->SetActiveVectors(name);
}

void AddVectors(vtkDataObject* data)
{
  if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(data))
  {
    if (!mesh->GetPointData()->GetVectors() && !mesh->GetCellData()->GetVectors())
    {
      AddVectors(mesh, Screw);
    }
  }
  else if (vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      AddVectors(iterator->GetCurrentDataObject());
    }
  }
}

vtkAdaptiveRefinementMapper* NewInvisible(vtkDataObject* data)
{
  AddVectors(data);
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::New();
  mapper->SetLICIntensity(0.0);
  mapper->SetNumberOfSteps(2);
  return mapper;
}

vtkAdaptiveRefinementMapper* NewVisible(vtkDataObject* data)
{
  AddVectors(data);
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::New();
  mapper->SetNumberOfSteps(8);
  return mapper;
}

vtkAdaptiveLICMapper* GetMapper(vtkActor* actor)
{
  return vtkAdaptiveLICMapper::SafeDownCast(actor->GetMapper());
}
}
