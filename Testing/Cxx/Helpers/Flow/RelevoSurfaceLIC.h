// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of vtkSurfaceLineIntegralConvolution share.
#ifndef RelevoSurfaceLIC_h
#define RelevoSurfaceLIC_h

#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkSurfaceLineIntegralConvolution.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <vector>

// A point array "Velocity", the active vectors.
inline void AddVelocity(vtkPolyData* mesh,
  const std::function<RelevoVectors::Vector(const RelevoVectors::Vector&)>& function)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Velocity");
  RelevoMeshes::FillVectors(mesh, function, vectors);
  mesh->GetPointData()->SetVectors(vectors);
}

// The output's arrays; empty when there is none.
struct RelevoSurfaceLIC
{
  explicit RelevoSurfaceLIC(vtkPolyData* output)
  {
    vtkDataArray* values = output->GetPointData()->GetArray("LIC");
    vtkDataArray* mask = output->GetPointData()->GetArray("LICMask");
    for (vtkIdType i = 0; values && mask && i < output->GetNumberOfPoints(); ++i)
    {
      this->Values.push_back(static_cast<float>(values->GetComponent(i, 0)));
      this->Mask.push_back(static_cast<int>(mask->GetComponent(i, 0)));
    }
  }
  RelevoSurfaceLIC(vtkSurfaceLineIntegralConvolution* filter, vtkPolyData* mesh)
    : RelevoSurfaceLIC((filter->SetInputData(mesh), filter->Update(), filter->GetOutput()))
  {
  }

  // Finite, and in [0, 1].
  bool IsValid() const
  {
    return !this->Values.empty() &&
      std::all_of(this->Values.begin(), this->Values.end(),
        [](float value) { return value >= 0.0f && value <= 1.0f; });
  }

  std::vector<float> Values;
  std::vector<int> Mask;
};

#endif
