// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoSurfaceLIC.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

void AddVelocity(vtkPolyData* mesh,
  const std::function<RelevoVectors::Vector(const RelevoVectors::Vector&)>& function)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Velocity");
  RelevoMeshes::FillVectors(mesh, function, vectors);
  mesh->GetPointData()->SetVectors(vectors);
}

RelevoSurfaceLIC::RelevoSurfaceLIC(vtkPolyData* output)
{
  vtkDataArray* values = output->GetPointData()->GetArray("LIC");
  vtkDataArray* mask = output->GetPointData()->GetArray("LICMask");
  for (vtkIdType i = 0; values && mask && i < output->GetNumberOfPoints(); ++i)
  {
    this->Values.push_back(static_cast<float>(values->GetComponent(i, 0)));
    this->Mask.push_back(static_cast<int>(mask->GetComponent(i, 0)));
  }
}

RelevoSurfaceLIC::RelevoSurfaceLIC(vtkSurfaceLineIntegralConvolution* filter, vtkPolyData* mesh)
  : RelevoSurfaceLIC((filter->SetInputData(mesh), filter->Update(), filter->GetOutput()))
{
}

bool RelevoSurfaceLIC::IsValid() const
{
  return !this->Values.empty() &&
    std::all_of(this->Values.begin(), this->Values.end(),
      [](float value) { return value >= 0.0f && value <= 1.0f; });
}
