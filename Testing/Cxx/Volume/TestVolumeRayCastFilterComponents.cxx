// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises vector modes and direct colours. Vector modes are compared with
// single-component arrays of the same values; colours are floats from 0 to 1 or bytes.
#include "RelevoCheck.h"
#include "RelevoVolumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
using Mode = vtkVolumeRayCastFilter::VectorModeType;

void TestVectorModes(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(3, [](const RelevoPoint&) { return 0.0; });
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("lengths");
  vtkNew<vtkDoubleArray> seconds;
  seconds->SetName("seconds");
  vtkNew<vtkDoubleArray> negatives;
  negatives->SetName("signed");
  vtkNew<vtkDoubleArray> absolutes;
  absolutes->SetName("absolute");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    const double v[3] = { p[0] - 0.5, 0.2 + 0.5 * p[1], 0.3 * p[2] };
    vectors->InsertNextTuple(v);
    lengths->InsertNextValue(std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    seconds->InsertNextValue(v[1]);
    negatives->InsertNextValue(v[0]);
    absolutes->InsertNextValue(std::abs(v[0]));
  }
  for (vtkDataArray* array :
    { vectors.Get(), lengths.Get(), seconds.Get(), negatives.Get(), absolutes.Get() })
  {
    mesh->GetPointData()->AddArray(array);
  }
  const auto property = MakeVolumeProperty(0.2, 1.0, 0.5);
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetCamera(MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } }));
  filter->SetVolumeProperty(property);
  filter->SetViewportSize(20, 20);
  const auto cast = [&](const char* name, int mode, int component = 0)
  {
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    filter->SetVectorMode(mode);
    filter->SetVectorComponent(component);
    return Cast(filter);
  };
  const auto length = cast("lengths", Mode::DISABLED);
  const auto second = cast("seconds", Mode::DISABLED);
  CHECK_GREATER(FindLargestDifference(length, second), 0.05);
  CHECK_LESS(FindLargestDifference(cast("vectors", Mode::MAGNITUDE), length), 1e-12);
  CHECK_LESS(FindLargestDifference(cast("vectors", Mode::COMPONENT, 1), second), 1e-12);
  property->GetRGBTransferFunction()->SetVectorModeToMagnitude();
  CHECK_LESS(FindLargestDifference(cast("vectors", Mode::DISABLED), length), 1e-12);
  CHECK_LESS(FindLargestDifference(cast("vectors", Mode::COMPONENT, 1), second), 1e-12);
  // A single component keeps its sign, as in vtkProjectedTetrahedraMapper.
  const auto signedMagnitude = cast("signed", Mode::DISABLED);
  CHECK_LESS(FindLargestDifference(cast("signed", Mode::MAGNITUDE), signedMagnitude), 1e-12);
  property->GetRGBTransferFunction()->SetVectorModeToComponent();
  CHECK_LESS(FindLargestDifference(cast("signed", Mode::DISABLED), signedMagnitude), 1e-12);
  CHECK_GREATER(FindLargestDifference(cast("absolute", Mode::DISABLED), signedMagnitude), 0.05);
  CHECK_GREATER(FindLargestDifference(cast("vectors", Mode::DISABLED), length), 0.05);

  RelevoErrors errors(filter);
  RelevoErrors executiveErrors(filter->GetExecutive());
  CHECK(cast("vectors", Mode::COMPONENT, 3).empty());
  CHECK(errors.Said("VectorComponent is 3, but the array has 3 components"));
  filter->SetVectorComponent(4);
  CHECK(errors.Said("VectorComponent must be in [0, 3], got 4"));
  filter->SetVectorMode(2);
  CHECK(errors.Said("VectorMode must be in [-1, 1], got 2"));
  CHECK_EQUAL(filter->GetVectorMode(), Mode::COMPONENT);
  CHECK_EQUAL(filter->GetVectorComponent(), 3);
}

// The components are red, green, blue and opacity.
void TestColors(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, [](const RelevoPoint&) { return 0.0; });
  vtkNew<vtkDoubleArray> shares;
  vtkNew<vtkUnsignedCharArray> bytes;
  shares->SetNumberOfComponents(4);
  bytes->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    shares->InsertNextTuple4(1.0, 0.2, 0.0, 0.4);
    bytes->InsertNextTuple4(255, 51, 0, 102);
  }
  const auto property = MakeVolumeProperty(0.0, 1.0, 0.5);
  property->IndependentComponentsOff();
  const auto camera = MakeCamera({ { 0.5, 0.5, 4.0 } }, { { 0.5, 0.5, 0.5 } });
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.4);
  const double alpha = 1.0 - std::exp(-0.4 / 0.5);
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(shares), static_cast<vtkDataArray*>(bytes) })
  {
    mesh->GetPointData()->SetScalars(array);
    for (const RelevoColor& color : Cast(mesh, property, camera, 4, 4))
    {
      CHECK_NEAR(color[0], alpha, 1e-12);
      CHECK_NEAR(color[1], 0.2 * alpha, 1e-12);
      CHECK_NEAR(color[2], 0.0, 1e-12);
      CHECK_NEAR(color[3], alpha, 1e-12);
    }
  }
}
}

int TestVolumeRayCastFilterComponents(int, char*[])
{
  RelevoCheck check;
  TestVectorModes(check);
  TestColors(check);
  return check.GetResult();
}
