// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that streaks of vtkSurfaceLineIntegralConvolution, drawn as point colours, follow the
// field as seen from two sides.
#include "RelevoSurfaceFields.h"

#include "vtkLookupTable.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSurfaceLineIntegralConvolution.h"

#include <iostream>

namespace
{
using Vector = std::array<double, 3>;

vtkSmartPointer<vtkActor> MakeGreyActor(vtkAlgorithmOutput* port)
{
  vtkNew<vtkLookupTable> greys;
  greys->SetSaturationRange(0.0, 0.0);
  greys->SetValueRange(0.0, 1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(port);
  mapper->SetLookupTable(greys);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Tests every second field, beginning with the first or the second.
void TestSurface(RelevoCheck& check, const std::string& name, vtkPolyData* mesh,
  const RelevoSurfaceField& normal, std::size_t first)
{
  const std::vector<RelevoNamedSurfaceField> fields = MakeSurfaceFields(normal);
  for (std::size_t i = first; i < fields.size(); i += 2)
  {
    const RelevoNamedSurfaceField& named = fields[i];
    vtkNew<vtkSurfaceLineIntegralConvolution> filter;
    filter->SetInputData(WithField(mesh, named.Field));
    filter->SetGrainSize(0.02);
    filter->SetNumberOfSteps(30);
    filter->SetEnhanceContrastToLIC();
    RelevoLICScene scene(640, 480);
    scene.Renderer->AddActor(MakeGreyActor(filter->GetOutputPort()));
    for (const Vector& from : { Vector{ { 1.0, -3.0, 3.0 } }, Vector{ { -3.0, 1.5, 2.0 } } })
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(from.data());
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewUp(0.1, 1.0, 0.3);
      scene.Renderer->ResetCamera();
      const RelevoDeviations deviations =
        MeasureStreaks(scene.Render(), scene.Renderer, named.Field, normal);
      std::cout << name << ", " << named.Name << ": " << deviations << "\n";
      CHECK_GREATER(deviations.Count, 15000);
      CHECK_LESS_EQUAL(deviations.Median, 2.5);
      // At a saddle, converging streaks are finer than the mesh.
      CHECK(named.Name == "saddle" || deviations.Percentile95 <= 11.0);
    }
  }
}
}

int TestSurfaceLineIntegralConvolutionDirections(int, char*[])
{
  RelevoCheck check;
  const double nowhere[3] = { 0.0, 0.0, 0.0 };
  TestSurface(check, "sphere",
    RelevoMeshes::Moved(RelevoMeshes::Sphere(360, 180), 2.0, nowhere, VTK_DOUBLE), NormalOfSphere,
    1);
  TestSurface(check, "torus", RelevoMeshes::Torus(400, 200), NormalOfTorus, 0);
  return check.GetResult();
}
