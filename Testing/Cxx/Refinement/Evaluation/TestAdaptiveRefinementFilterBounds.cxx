// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the bounds of a mesh under a recipe contain the filter's output and are not much
// larger.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"

#include <random>

using namespace RelevoMeshes;

int TestAdaptiveRefinementFilterBounds(int, char*[])
{
  RelevoCheck check;
  Mesh wild = Explode(Sphere(8, 6));
  PerturbNormals(wild, 3, 0.9);
  const double utm[3] = { 412345.678, 5654321.987, 312.5 };
  const std::pair<const char*, Mesh> meshes[] = { { "sphere", Sphere(12, 9) }, { "cube", Cube() },
    { "plane", Plane(3, 3) }, { "wild normals", wild }, { "strips", Strips() },
    { "slivers", Slivers() }, { "projected metres", Moved(Sphere(12, 9), 50.0, utm, VTK_DOUBLE) } };
  for (const auto& mesh : meshes)
  {
    AddRandomTextureCoordinates(mesh.second, 3);
    const double size = mesh.second->GetLength();
    for (const auto& surface : RelevoMakeSurfaces(0.3 * size))
    {
      for (int displaced = 0; displaced < 4; ++displaced)
      {
        vtkNew<RelevoHeights> heights;
        // Heights from -0.5 to 0.5. A negative scale with an offset tests the other end of the
        // range.
        std::mt19937 random(7);
        heights->Fill(20, 20, [&random](double, double) { return random() / 4294967296.0 - 0.5; });
        auto displacement = MakeDisplacement(
          heights, (displaced == 2 ? -0.3 : 0.3) * size, displaced == 2 ? 0.2 * size : 0.0);
        if (displaced == 3)
        {
          displacement->SetDirection(1.0, -0.5, 0.0);
        }
        vtkNew<vtkAdaptiveRefinement> recipe;
        recipe->SetMaximumLevel(4);
        recipe->SetSurface(surface.second);
        recipe->SetDisplacement(displaced > 0 ? displacement.Get() : nullptr);
        vtkNew<vtkAdaptiveRefinementFilter> filter;
        filter->SetInputData(mesh.second);
        filter->SetRefinement(recipe);
        filter->Update();
        relevo::RefinementMesh refinementMesh;
        CHECK(refinementMesh.Build(mesh.second, recipe->GetSurface(), recipe->GetDisplacement()));
        double bounds[6];
        double reached[6];
        relevo::ComputeBounds(
          refinementMesh, recipe->GetSurface(), recipe->GetDisplacement(), bounds);
        filter->GetOutput()->GetBounds(reached);
        double margin = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          const double below = reached[2 * c] - bounds[2 * c];
          const double above = bounds[2 * c + 1] - reached[2 * c + 1];
          if (below < -1e-6 * size || above < -1e-6 * size)
          {
            check.Fail(__FILE__, __LINE__,
              std::string(mesh.first) + ", " + surface.first + ", displacement " +
                std::to_string(displaced) + ": beyond the bounds by " +
                std::to_string(-std::min(below, above) / size));
          }
          margin = std::max({ margin, below, above });
        }
        // Without a surface and a displacement the bounds are exact. Control points of slivers lie
        // far outside, and unknown normals let a displacement point anywhere.
        const bool known = !surface.second || surface.second->HasInterpolatedNormals();
        const double slivers = surface.second && mesh.first == std::string("slivers") ? 0.1 : 0.0;
        const double most = slivers +
          (displaced           ? (known ? 0.5 : 0.8)
              : surface.second ? 0.2
                               : 1e-6);
        if (margin >= most * size)
        {
          check.Fail(__FILE__, __LINE__,
            std::string(mesh.first) + ", " + surface.first + ", displacement " +
              std::to_string(displaced) + ": bounds are too large by " +
              std::to_string(margin / size));
        }
      }
    }
  }
  return check.GetResult();
}
