// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that on coarse meshes refined where the field varies, streaks are closer to those of a
// dense mesh, and to the field, than on the coarse mesh.
#include "RelevoSurfaceFields.h"

#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkPNTriangleSurface.h"

#include <iostream>

namespace
{
constexpr int Width = 480;
constexpr int Height = 360;
using Vector = std::array<double, 3>;
using RelevoMeshes::Mesh;

struct Result
{
  RelevoLICPicture Picture;
  vtkIdType Triangles;
};

struct Surface
{
  std::string Name;
  Mesh Coarse;
  Mesh Dense;
  RelevoSurfaceField Normal;
};

Result Draw(const Surface& surface, vtkPolyData* mesh, const RelevoSurfaceField& field,
  vtkAdaptiveRefinement* recipe = nullptr)
{
  RelevoLICScene scene(Width, Height);
  vtkAdaptiveLICMapper* mapper =
    scene.Add(WithField(WithNormals(mesh, surface.Normal), field), recipe);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(1.2, -2.6, 3.2);
  camera->SetViewAngle(40.0);
  scene.Renderer->ResetCameraClippingRange(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
  const RelevoLICPicture picture = scene.Render();
  return { picture, mapper->GetNumberOfDrawnTriangles() };
}

// Angles between the streaks of two pictures.
RelevoDeviations MeasureAngles(const RelevoLICPicture& picture, const RelevoLICPicture& expected)
{
  const RelevoOrientation orientation(expected.GetFilled());
  return MeasureDeviations(RelevoOrientation(picture.GetFilled()),
    [&](int column, int row, double* vector)
    {
      vector[0] = std::cos(orientation.GetAngle(column, row));
      vector[1] = std::sin(orientation.GetAngle(column, row));
      return picture.HasLIC(column, row, 8) && expected.HasLIC(column, row, 8);
    });
}

void TestRefinement(
  RelevoCheck& check, const Surface& surface, const RelevoNamedSurfaceField& field)
{
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkFieldVariationDepthTagMetric> metric;
  metric->SetArrayName("Flow");
  const auto recipe = RelevoMeshes::MakeRecipe(3, pn);
  recipe->SetMetric(metric);
  const Result dense = Draw(surface, surface.Dense, field.Field);
  const Result coarse = Draw(surface, surface.Coarse, field.Field);
  const Result refined = Draw(surface, surface.Coarse, field.Field, recipe);
  const RelevoDeviations ofCoarse = MeasureAngles(coarse.Picture, dense.Picture);
  const RelevoDeviations ofRefined = MeasureAngles(refined.Picture, dense.Picture);
  const RelevoLikeness likeCoarse = CompareLIC(coarse.Picture, dense.Picture);
  const RelevoLikeness likeRefined = CompareLIC(refined.Picture, dense.Picture);
  std::cout << surface.Name << ", " << field.Name << ": dense, " << dense.Triangles
            << " triangles\n  coarse, " << coarse.Triangles << ": " << ofCoarse << "; "
            << likeCoarse << "\n  refined, " << refined.Triangles << ": " << ofRefined << "; "
            << likeRefined << "\n";
  CHECK_LESS(refined.Triangles, dense.Triangles);
  // Refinement cannot add detail that is not in the vectors of the coarse points.
  CHECK_LESS(ofRefined.Median, 0.95 * ofCoarse.Median);
  CHECK_LESS(ofRefined.Percentile95, 0.93 * ofCoarse.Percentile95);
  CHECK_LESS(1.0 - likeRefined.SSIM, 0.93 * (1.0 - likeCoarse.SSIM));
  CHECK_LESS(likeRefined.MeanDifference, 0.9 * likeCoarse.MeanDifference);
  CHECK_LESS(likeRefined.OneSided, 0.5 * likeCoarse.OneSided);
}
}

int TestAdaptiveLICMapperAdaptive(int, char*[])
{
  RelevoCheck check;
  const Vector origin{ { 0.0, 0.0, 0.0 } };
  const auto sphere = [&](int theta, int phi)
  { return RelevoMeshes::Moved(RelevoMeshes::Sphere(theta, phi), 2.4, origin.data(), VTK_DOUBLE); };
  const Surface surfaces[] = { { "sphere", sphere(12, 8), sphere(240, 120), NormalOfSphere },
    { "torus", RelevoMeshes::Torus(20, 12), RelevoMeshes::Torus(240, 120), NormalOfTorus } };
  for (const Surface& surface : surfaces)
  {
    for (const RelevoNamedSurfaceField& field : MakeSurfaceFields(surface.Normal))
    {
      TestRefinement(check, surface, field);
    }
  }
  return check.GetResult();
}
