// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveLICMapper promises: streaks follow the projected field on a plane that faces the
// camera, and in perspective on planes, spheres and tori, also from close by and away from their
// axes.
#include "RelevoSurfaceFields.h"

#include <iostream>

namespace
{
constexpr int Width = 640;
constexpr int Height = 480;
using Vector = std::array<double, 3>;

Vector NormalOfPlane(const Vector&)
{
  return { { 0.0, 0.0, 1.0 } };
}

void Look(vtkRenderer* renderer, const Vector& from, const Vector& at, double angle)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(at.data());
  camera->SetViewUp(0.1, 1.0, 0.3);
  camera->SetViewAngle(angle);
  renderer->ResetCameraClippingRange();
}

void Expect(RelevoCheck& check, const std::string& name, const RelevoDeviations& deviations)
{
  std::cout << name << ": " << deviations << "\n";
  CHECK_GREATER(deviations.Count, 15000);
  CHECK_LESS_EQUAL(deviations.Median, 1.5);
  CHECK_LESS_EQUAL(deviations.Percentile95, 5.0);
}

// One pixel is one unit, so the field equals its projection.
void TestFacingPlane(RelevoCheck& check)
{
  const auto place = [](double sample, int number)
  { return (sample - 0.5 * number) / (0.5 * Height); };
  for (const RelevoNamedField& named : MakeNamedFields())
  {
    CHECK_CASE(named.Name);
    const RelevoField field = [&](double x, double y, double* v)
    { named.Field(place(x, Width), place(y, Height), v); };
    RelevoLICScene scene(Width, Height);
    scene.Add(MakePixelMesh(Width, Height, 4, field));
    scene.LookAtPixels();
    const RelevoLICPicture picture = scene.Render();
    Expect(check, "plane, " + named.Name,
      MeasureDeviations(RelevoOrientation(picture.Grey),
        [&](int column, int row, double* vector)
        {
          const double x = place(column + 0.5, Width);
          const double y = place(row + 0.5, Height);
          field(column + 0.5, row + 0.5, vector);
          bool counts = picture.HasLIC(column, row, 12);
          for (const auto& singularity : named.Singularities)
          {
            counts = counts && std::hypot(x - singularity[0], y - singularity[1]) > 0.1;
          }
          return counts;
        }));
  }
}

struct View
{
  Vector From;
  Vector At;
  double Angle;
};

void TestSurface(RelevoCheck& check, const std::string& name, vtkPolyData* mesh,
  const RelevoSurfaceField& normal, const std::vector<View>& views)
{
  for (const RelevoNamedSurfaceField& named : MakeSurfaceFields(normal))
  {
    CHECK_CASE(named.Name);
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      RelevoLICScene scene(Width, Height);
      scene.Add(WithField(mesh, named.Field));
      Look(scene.Renderer, views[i].From, views[i].At, views[i].Angle);
      Expect(check, name + ", " + named.Name + ", view " + std::to_string(i),
        MeasureStreaks(scene.Render(), scene.Renderer, named.Field, normal));
    }
  }
}

// Negative control: with the directions of a parallel projection the check fails, so it detects
// perspective.
void TestPerspective(RelevoCheck& check, vtkPolyData* mesh, const View& view)
{
  const RelevoSurfaceField away = [](const Vector&) { return Vector{ { 0.0, 1.0, 0.0 } }; };
  RelevoLICScene scene(Width, Height);
  scene.Add(WithField(mesh, away));
  Look(scene.Renderer, view.From, view.At, view.Angle);
  const RelevoLICPicture picture = scene.Render();
  Expect(
    check, "lines to the horizon", MeasureStreaks(picture, scene.Renderer, away, NormalOfPlane));

  vtkMatrix4x4* toView = scene.Renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  const RelevoDeviations parallel = MeasureDeviations(RelevoOrientation(picture.GetFilled()),
    [&](int column, int row, double* vector)
    {
      vector[0] = toView->GetElement(0, 1);
      vector[1] = toView->GetElement(1, 1);
      return picture.HasLIC(column, row, 8);
    });
  std::cout << "as in parallel projection: " << parallel << "\n";
  CHECK_GREATER(parallel.Median, 5.0);
}
}

int TestAdaptiveLICMapperDirections(int, char*[])
{
  RelevoCheck check;
  TestFacingPlane(check);
  const auto sphere = RelevoMeshes::Moved(
    RelevoMeshes::Sphere(160, 80), 2.0, Vector{ { 0.0, 0.0, 0.0 } }.data(), VTK_DOUBLE);
  TestSurface(check, "sphere", sphere, NormalOfSphere,
    { { { { 1.0, 0.8, 2.5 } }, { { 0.0, 0.0, 0.0 } }, 45.0 },
      { { { 0.5, 0.4, 1.6 } }, { { 0.6, -0.5, 0.0 } }, 75.0 } });
  TestSurface(check, "torus", RelevoMeshes::Torus(160, 80), NormalOfTorus,
    { { { { 1.0, -3.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 45.0 },
      { { { 0.4, -1.5, 1.6 } }, { { 0.7, -0.2, 0.0 } }, 80.0 } });
  const auto plane = RelevoMeshes::Moved(
    RelevoMeshes::Plane(80, 80), 2.0, Vector{ { 0.0, 0.0, 0.0 } }.data(), VTK_DOUBLE);
  const View low{ { { 0.6, -1.1, 0.7 } }, { { 0.0, 0.1, 0.0 } }, 80.0 };
  TestSurface(check, "plane", plane, NormalOfPlane, { low });
  TestPerspective(check, plane, low);
  return check.GetResult();
}
