// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPNTriangleSurface promises the patch of Vlachos et al. It is compared with the closed formula,
// computed in double, and checked on spheres and cubes.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkDoubleArray.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"

#include <algorithm>
#include <random>

using namespace RelevoMeshes;
using namespace RelevoVectors;

namespace
{
// The formula is that of Vlachos et al. 2001, with w for P1, u for P2 and v for P3.
struct PNTriangle
{
  Vector P[3];
  Vector N[3];

  Vector control(int i, int j) const
  {
    const double w = dot(this->P[j] - this->P[i], this->N[i]);
    return 1.0 / 3.0 * (2.0 * this->P[i] + this->P[j] - w * this->N[i]);
  }
  Vector position(double w, double u, double v) const
  {
    const Vector b210 = control(0, 1);
    const Vector b120 = control(1, 0);
    const Vector b021 = control(1, 2);
    const Vector b012 = control(2, 1);
    const Vector b102 = control(2, 0);
    const Vector b201 = control(0, 2);
    const Vector e = 1.0 / 6.0 * (b210 + b120 + b021 + b012 + b102 + b201);
    const Vector corners = 1.0 / 3.0 * (this->P[0] + this->P[1] + this->P[2]);
    const Vector b111 = e + 0.5 * (e - corners);
    return w * w * w * this->P[0] + u * u * u * this->P[1] + v * v * v * this->P[2] +
      3 * w * w * u * b210 + 3 * w * u * u * b120 + 3 * w * w * v * b201 + 3 * u * u * v * b021 +
      3 * w * v * v * b102 + 3 * u * v * v * b012 + 6 * w * u * v * b111;
  }
  Vector middle(int i, int j) const
  {
    const Vector edge = this->P[j] - this->P[i];
    const Vector sum = this->N[i] + this->N[j];
    return normalize(sum - 2.0 * dot(edge, sum) / dot(edge, edge) * edge);
  }
  Vector quadraticNormal(double w, double u, double v) const
  {
    return normalize(w * w * this->N[0] + u * u * this->N[1] + v * v * this->N[2] +
      w * u * middle(0, 1) + u * v * middle(1, 2) + w * v * middle(2, 0));
  }
  Vector linearNormal(double w, double u, double v) const
  {
    return normalize(w * this->N[0] + u * this->N[1] + v * this->N[2]);
  }
};

Mesh refine(vtkPolyData* input, vtkRefinementSurface* surface, int level)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(level);
  recipe->SetSurface(surface);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(input);
  filter->SetRefinement(recipe);
  filter->Update();
  return filter->GetOutput();
}

// Random triangles with random normals, levels and orders of corner ids.
void testFormula(RelevoCheck& check)
{
  std::mt19937 random(9);
  auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  int order[3] = { 0, 1, 2 };
  int tested = 0;
  do
  {
    for (int sample = 0; sample < 10; ++sample)
    {
      PNTriangle pn;
      std::vector<Vector> points(3);
      vtkNew<vtkFloatArray> normals;
      normals->SetNumberOfComponents(3);
      normals->SetNumberOfTuples(3);
      vtkNew<vtkDoubleArray> weights; // one per corner of the cell, in the cell's order
      weights->SetName("weights");
      weights->SetNumberOfComponents(3);
      weights->SetNumberOfTuples(3);
      weights->Fill(0.0);
      for (int i = 0; i < 3; ++i)
      {
        pn.P[i] = { { number(), number(), number() } };
        pn.N[i] = normalize({ { 0.6 * number(), 0.6 * number(), 1.0 } });
        points[order[i]] = pn.P[i];
        normals->SetTuple(order[i], pn.N[i].data());
        weights->SetComponent(order[i], i, 1.0);
      }
      Mesh mesh = FromTriangles(points, { { { order[0], order[1], order[2] } } });
      mesh->GetPointData()->SetNormals(normals);
      mesh->GetPointData()->AddArray(weights);
      AddTags(mesh, static_cast<unsigned int>(sample), 5);
      for (bool quadratic : { true, false })
      {
        CHECK_CASE(quadratic);
        vtkNew<vtkPNTriangleSurface> surface;
        CHECK(surface->GetQuadraticNormals());
        surface->SetQuadraticNormals(quadratic);
        Mesh refined = refine(mesh, surface, 4);
        for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
        {
          double w[3];
          refined->GetPointData()->GetArray("weights")->GetTuple(i, w);
          CHECK_NEAR(w[0] + w[1] + w[2], 1.0, 1e-12);
          const Vector position = pn.position(w[0], w[1], w[2]);
          const Vector normal =
            quadratic ? pn.quadraticNormal(w[0], w[1], w[2]) : pn.linearNormal(w[0], w[1], w[2]);
          for (int c = 0; c < 3; ++c)
          {
            CHECK_NEAR(refined->GetPoint(i)[c], position[c], 2e-6);
            CHECK_NEAR(refined->GetPointData()->GetNormals()->GetComponent(i, c), normal[c], 1e-5);
          }
          ++tested;
        }
      }
    }
  } while (std::next_permutation(order, order + 3));
  CHECK_GREATER(tested, 5000);
}

// Largest distance of a mesh's points from the sphere of radius 0.5.
double getDistance(vtkPolyData* mesh)
{
  double distance = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    distance = std::max(distance, std::abs(vtkMath::Norm(mesh->GetPoint(i)) - 0.5));
  }
  return distance;
}

void testSphere(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  double last = 1.0;
  for (int resolution : { 8, 16, 32 })
  {
    Mesh sphere = Sphere(resolution, resolution);
    Mesh linear = refine(sphere, nullptr, 3);
    Mesh pn = refine(sphere, surface, 3);
    CHECK_LESS(getDistance(pn), 0.2 * getDistance(linear));
    // Convergence has at least third order.
    CHECK_LESS(getDistance(pn), last / 8.0);
    last = getDistance(pn);
    for (vtkIdType i = 0; i < pn->GetNumberOfPoints(); ++i)
    {
      double radial[3];
      pn->GetPoint(i, radial);
      vtkMath::Normalize(radial);
      CHECK_GREATER(vtkMath::Dot(radial, pn->GetPointData()->GetNormals()->GetTuple(i)), 0.99);
    }
  }
}

// A cube has split normals, so its faces stay flat and its edges straight and sharp.
void testCube(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  Mesh cube = Cube();
  Mesh refined = refine(cube, surface, 4);
  CHECK_EQUAL(refined->GetNumberOfPolys(), 12 * 256);
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const double* p = refined->GetPoint(i);
    const double largest = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    CHECK_NEAR(largest, 0.5, 1e-6);
    const double* n = refined->GetPointData()->GetNormals()->GetTuple(i);
    CHECK_NEAR(vtkMath::Dot(p, n), 0.5, 1e-6);
    CHECK_NEAR(std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) }), 1.0, 1e-6);
  }
  // Without normals the cube is rounded, but still closed.
  cube->GetPointData()->SetNormals(nullptr);
  Mesh rounded = refine(cube, surface, 4);
  double bounds[6];
  rounded->GetBounds(bounds);
  CHECK_GREATER(bounds[1], 0.55);
}

// A flat mesh stays flat, bit for bit if its normals are exact.
void testPlane(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  Mesh refined = refine(Plane(3, 2), surface, 3);
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(refined->GetPoint(i)[2], 0.0);
    CHECK_EQUAL(refined->GetPointData()->GetNormals()->GetComponent(i, 2), 1.0);
  }
}
}

int TestPNTriangleSurface(int, char*[])
{
  RelevoCheck check;
  testFormula(check);
  testSphere(check);
  testCube(check);
  testPlane(check);
  vtkNew<vtkPNTriangleSurface> surface;
  CHECK_NOT_EQUAL(
    surface->GetShaderSource().find("vec3 surfacePosition(vec3 w)"), std::string::npos);
  CHECK_NOT_EQUAL(surface->GetShaderSource().find("vec3 surfaceNormal(vec3 w)"), std::string::npos);
  return check.GetResult();
}
