// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that refined vtkG1Surface meshes deviate from the sampled shapes as little as PN triangles
// do, see the table in figures.md.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkG1Surface.h"
#include "vtkPNTriangleSurface.h"

#include <algorithm>
#include <iostream>

using namespace RelevoMeshes;
using namespace RelevoVectors;

namespace
{
// Largest and root mean square distance of a refined mesh's points from a surface.
struct Deviation
{
  double Largest = 0.0;
  double Mean = 0.0;

  Deviation(
    vtkPolyData* mesh, vtkRefinementSurface* surface, double (*getDistance)(const Vector& point))
  {
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetMaximumLevel(4);
    recipe->SetSurface(surface);
    Mesh refined = Refine(mesh, recipe);
    const vtkIdType n = refined->GetNumberOfPoints();
    for (vtkIdType i = 0; i < n; ++i)
    {
      Vector p;
      refined->GetPoint(i, p.data());
      const double distance = std::abs(getDistance(p));
      this->Largest = std::max(this->Largest, distance);
      this->Mean += distance * distance / n;
    }
    this->Mean = std::sqrt(this->Mean);
  }
};

double fromSphere(const Vector& p)
{
  return length(p) - 0.5;
}

double fromTorus(const Vector& p)
{
  return std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]) - 0.5;
}

// Deviations from known surfaces are as small as those of PN triangles.
void testDeviation(RelevoCheck& check, vtkG1Surface* surface)
{
  vtkNew<vtkPNTriangleSurface> pn;
  const struct
  {
    const char* Name;
    Mesh Coarse;
    Mesh Fine;
    double (*GetDistance)(const Vector& point);
  } cases[] = { { "sphere", Sphere(8, 6), Sphere(16, 11), fromSphere },
    { "torus", Torus(14, 9), Torus(27, 17), fromTorus } };
  for (const auto& test : cases)
  {
    double last = 0.0;
    for (const Mesh& mesh : { test.Coarse, test.Fine })
    {
      const Deviation flat(mesh, nullptr, test.GetDistance);
      const Deviation cubic(mesh, pn, test.GetDistance);
      const Deviation smooth(mesh, surface, test.GetDistance);
      std::cout << test.Name << ", " << mesh->GetNumberOfPolys()
                << " triangles: distance (largest, RMS) " << flat.Largest << " " << flat.Mean
                << " (linear), " << cubic.Largest << " " << cubic.Mean << " (PN), "
                << smooth.Largest << " " << smooth.Mean << " (G1)\n";
      CHECK_LESS(smooth.Largest, 0.2 * flat.Largest);
      CHECK_LESS(smooth.Largest, 1.01 * cubic.Largest);
      CHECK_LESS(smooth.Mean, cubic.Mean);
      // Convergence has at least third order.
      CHECK(last == 0.0 || smooth.Mean < last / 8.0);
      last = smooth.Mean;
    }
  }
}
}

int TestG1SurfaceDeviation(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkG1Surface> surface;
  surface->GeometricNormalsOn();
  testDeviation(check, surface);
  return check.GetResult();
}
