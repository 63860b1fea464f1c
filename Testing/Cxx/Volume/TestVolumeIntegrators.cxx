// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that segments of rays have the same integrals as in
// vtkUnstructuredGridLinearRayIntegrator.
#include "Integral/TransferFunctions.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnstructuredGridLinearRayIntegrator.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
void CheckRay(RelevoCheck& check, RelevoDice& dice)
{
  vtkNew<vtkVolumeProperty> property;
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  for (int i = 0; i <= 4; ++i)
  {
    property->GetRGBTransferFunction()->AddRGBPoint(
      0.25 * i, dice.Share(), dice.Share(), dice.Share());
    opacity->AddPoint(0.25 * i, dice.Share());
  }
  property->SetScalarOpacityUnitDistance(0.5 + dice.Share());
  vtkNew<vtkVolume> volume;
  volume->SetProperty(property);

  const int count = 20;
  vtkNew<vtkDoubleArray> lengths;
  vtkNew<vtkDoubleArray> nearest;
  vtkNew<vtkDoubleArray> farthest;
  for (int i = 0; i < count; ++i)
  {
    lengths->InsertNextValue(0.3 * dice.Share());
    nearest->InsertNextValue(dice.Share());
    farthest->InsertNextValue(dice.Share());
  }
  vtkNew<vtkUnstructuredGridLinearRayIntegrator> integrator;
  integrator->Initialize(volume, nearest);
  float theirs[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  integrator->Integrate(lengths, nearest, farthest, theirs);

  relevo::TransferFunctions functions;
  std::string error;
  std::string warning;
  CHECK(functions.Read(property, 1, error, warning));
  relevo::dvec4 ours(0.0);
  for (int i = 0; i < count; ++i)
  {
    ours = relevo::frontOverBack(ours,
      functions.Integrate(
        { nearest->GetValue(i) }, { farthest->GetValue(i) }, lengths->GetValue(i)));
  }
  for (int c = 0; c < 4; ++c)
  {
    CHECK_NEAR(ours[c], theirs[c], 2e-4);
  }
}
}

int TestVolumeIntegrators(int, char*[])
{
  RelevoCheck check;
  RelevoDice dice(1);
  for (int i = 0; i < 50; ++i)
  {
    CheckRay(check, dice);
  }
  return check.GetResult();
}
