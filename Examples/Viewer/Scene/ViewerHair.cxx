// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerHair.h"

#include "Options/ViewerOptions.h"
#include "Scene/ViewerPatches.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkAdaptiveCurveMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkHairSource.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

namespace
{
const double Length = 0.05; // relative to the diagonal
const double Droop = 0.25;  // relative to the length

double GetArea(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(surface);
  properties->Update();
  return properties->GetSurfaceArea();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> GrowHair(
  const ViewerOptions& options, vtkPolyData* surface, ViewerMessages& messages)
{
  const double area = GetArea(surface);
  if (!(area > 0.0))
  {
    throw ViewerError(options.Input + " has no area for hair to grow on");
  }
  vtkNew<vtkPolyDataNormals> outwards; // scans may be inside out
  outwards->SetInputData(surface);
  outwards->SplittingOff();
  outwards->AutoOrientNormalsOn();
  vtkNew<vtkHairSource> hair;
  messages.Observe(hair, "growing hair");
  hair->SetInputConnection(outwards->GetOutputPort());
  hair->SetDensity(options.Hairs / area);
  hair->SetLength(Length * surface->GetLength());
  double gravity[3] = { 0.0, 0.0, 0.0 };
  gravity[options.UpAxis] = -Droop;
  hair->SetGravity(gravity);
  hair->Update();
  messages.Check();

  vtkNew<vtkAdaptiveRefinement> recipe;
  const auto metric = MakeErrorMetric(options);
  messages.Observe(metric);
  recipe->SetMetric(metric);
  recipe->SetMaximumLevel(7);
  recipe->SetSegmentPolicyToWholeNumbers();
  vtkNew<vtkAdaptiveCurveMapper> mapper;
  messages.Observe(mapper);
  mapper->SetInputData(hair->GetOutput());
  mapper->SetRefinement(recipe);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.55, 0.40, 0.26);
  actor->GetProperty()->SetAmbient(0.15);
  actor->GetProperty()->SetSpecular(0.2);
  return actor.Get();
}
