// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors for test meshes, and mappers that show them.
#ifndef RelevoLICVectors_h
#define RelevoLICVectors_h

#include "RelevoScene.h"

#include "vtkAdaptiveLICMapper.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <functional>

namespace RelevoLICVectors
{
using Field = std::function<std::array<double, 3>(const double*)>;

// A screw about the z axis, never zero near the origin.
inline std::array<double, 3> Screw(const double* p)
{
  return { { -p[1] + 0.3 * p[2], p[0], 1.0 - 0.3 * p[0] } };
}

// Active vectors of points, by their place.
inline void AddVectors(vtkPolyData* mesh, const Field& field = Screw, const char* name = "Flow")
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

// Of all blocks that have none.
inline void AddVectors(vtkDataObject* data)
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

// For RelevoScene::NewMapper: a LIC that is made but has no share in the colours.
inline vtkAdaptiveRefinementMapper* NewInvisible(vtkDataObject* data)
{
  AddVectors(data);
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::New();
  mapper->SetLICIntensity(0.0);
  mapper->SetNumberOfSteps(2);
  return mapper;
}

// For RelevoScene::NewMapper: the LIC with enhancements off, so that it is the same where nothing
// differs nearby.
inline vtkAdaptiveRefinementMapper* NewVisible(vtkDataObject* data)
{
  AddVectors(data);
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::New();
  mapper->SetNumberOfSteps(8);
  return mapper;
}

inline vtkAdaptiveLICMapper* GetMapper(vtkActor* actor)
{
  return vtkAdaptiveLICMapper::SafeDownCast(actor->GetMapper());
}
}

#endif
