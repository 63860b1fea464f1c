// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that parametric surfaces are drawn as vtkPolyDataMapper draws them at level 0, or the
// filter's output at level 2: curvature in hues that may wrap around, and points with undefined
// normals.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCurvatures.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkParametricEllipsoid.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"

#include <iostream>
#include <limits>

namespace
{
using namespace RelevoMeshes;

Mesh MakeSurface(vtkParametricFunction* function)
{
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(function);
  source->SetUResolution(25);
  source->SetVResolution(16);
  source->SetScalarModeToNone();
  source->Update();
  return source->GetOutput();
}

Mesh MakeCurvedTorus()
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkCurvatures> curvatures;
  curvatures->SetInputData(MakeSurface(torus));
  curvatures->SetCurvatureTypeToGaussian();
  curvatures->Update();
  return curvatures->GetOutput();
}

// Number of points whose normal has no direction.
vtkIdType CountMissingNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double normal[3];
    normals->GetTuple(i, normal);
    count += vtkMath::Norm(normal) > 0.0 ? 0 : 1;
  }
  return count;
}

// Some normals are zero, and some are NaN.
Mesh MakeSphereWithoutSomeNormals()
{
  Mesh mesh = Sphere(9, 7);
  vtkNew<vtkFloatArray> normals;
  normals->DeepCopy(mesh->GetPointData()->GetNormals());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 3)
  {
    const float component = i % 2 ? 0.0f : std::numeric_limits<float>::quiet_NaN();
    normals->SetTuple3(i, component, component, component);
  }
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

void TestHues(RelevoComparison& comparison)
{
  Mesh torus = MakeCurvedTorus();
  double range[2];
  torus->GetPointData()->GetScalars()->GetRange(range);
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.0, 1.0);
  table->SetTableRange(range);
  table->Build();
  for (int level : { 0, 2 })
  {
    for (bool before : { false, true })
    {
      const std::string name =
        "Hues." + std::to_string(level) + (before ? ".BeforeMapping" : ".AfterMapping");
      RelevoTolerance tolerance;
      tolerance.Color = level > 0 ? 1 : 0; // rounded
      comparison.Compare(name, tolerance,
        [&](RelevoScene& scene)
        {
          auto recipe = level > 0 ? MakeRecipe(level) : nullptr;
          vtkMapper* mapper = scene.Add(torus, recipe)->GetMapper();
          mapper->SetLookupTable(table);
          mapper->SetScalarRange(range);
          mapper->SetInterpolateScalarsBeforeMapping(before);
        });
    }
  }
}
}

int TestAdaptiveRefinementMapperParametric(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestHues(comparison);

  vtkNew<vtkParametricEllipsoid> ellipsoid;
  ellipsoid->SetZRadius(0.3);
  const std::pair<std::string, Mesh> meshes[] = { { "Ellipsoid", MakeSurface(ellipsoid) },
    { "Sphere", MakeSphereWithoutSomeNormals() } };
  for (const auto& mesh : meshes)
  {
    std::cout << mesh.first << " has " << CountMissingNormals(mesh.second)
              << " points with undefined normals\n";
    CHECK_GREATER(CountMissingNormals(mesh.second), 0);
    auto recipe = MakeRecipe(2);
    // The mapper's mesh follows a recipe that stops refining, and then refines again.
    comparison.Compare("Normals." + mesh.first, {},
      [&](RelevoScene& scene) { scene.Add(mesh.second, recipe); },
      { { "Again",
        [&](RelevoScene& scene)
        {
          recipe->SetMaximumLevel(0);
          scene.Render();
          recipe->SetMaximumLevel(2);
        } } });
    comparison.Compare(
      "Normals." + mesh.first + ".Coarse", {}, [&](RelevoScene& scene) { scene.Add(mesh.second); });
  }
  return check.GetResult();
}
