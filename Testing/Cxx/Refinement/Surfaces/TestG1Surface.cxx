// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkG1Surface promises: neighbouring patches share tangent planes along their edges. Points are
// compared with the quartic patch of its documentation, computed in double; tangent planes and
// normals with finite differences.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkG1Surface.h"
#include "vtkPLYReader.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkQuadricDecimation.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

using namespace RelevoMeshes;
using namespace RelevoVectors;
using relevo::EdgeCorners;

namespace
{
constexpr double Epsilon = 1.0 / 128.0; // step of finite differences

// The faces of a mesh with a surface.
class Patches
{
public:
  Patches(vtkPolyData* mesh, vtkRefinementSurface* surface)
    : Built((this->Recipe->SetSurface(surface), this->Mesh.Build(mesh, surface, nullptr)))
    , Evaluator(this->Mesh, this->Recipe)
  {
  }

  int GetNumberOfFaces() const { return static_cast<int>(this->Mesh.Faces.size()); }

  Vector GetPoint(int face, const Vector& w) const { return this->Evaluate(face, w)[0]; }
  Vector GetNormal(int face, const Vector& w) const { return this->Evaluate(face, w)[1]; }

  // Normal of the tangent plane by differences of points inside the face. It points to the side of
  // `outside`.
  Vector MeasureNormal(int face, const Vector& w, const Vector& outside) const
  {
    const Vector moves[2] = { { { -1.0, 1.0, 0.0 } }, { { -1.0, 0.0, 1.0 } } };
    Vector tangents[2];
    for (int i = 0; i < 2; ++i)
    {
      tangents[i] = this->GetDifference(face, w, moves[i]);
    }
    return this->Orient(cross(tangents[0], tangents[1]), outside);
  }

  // Normal on an edge of the face, computed from points of this face only.
  Vector MeasureEdgeNormal(int face, int edge, double t, const Vector& outside) const
  {
    Vector w = { { 0.0, 0.0, 0.0 } };
    Vector along = w;
    Vector into = { { -0.5, -0.5, -0.5 } };
    w[EdgeCorners[edge][0]] = 1.0 - t;
    w[EdgeCorners[edge][1]] = t;
    along[EdgeCorners[edge][0]] = -1.0;
    along[EdgeCorners[edge][1]] = 1.0;
    into[3 - EdgeCorners[edge][0] - EdgeCorners[edge][1]] = 1.0;
    // The difference is one-sided and of third order.
    Vector across = { { 0.0, 0.0, 0.0 } };
    const double factors[4] = { -11.0, 18.0, -9.0, 2.0 };
    for (int k = 0; k < 4; ++k)
    {
      across = across + factors[k] * this->GetPoint(face, w + (k * Epsilon) * into);
    }
    return this->Orient(cross(this->GetDifference(face, w, along), across), outside);
  }

  // Angles in degrees between tangent planes of two faces: the largest and the root mean square
  // over all edges that two faces share with the same normals.
  void MeasureJumps(double& largest, double& mean) const
  {
    std::map<std::pair<int, int>, std::vector<int>> sharing;
    for (int i = 0; i < 3 * this->GetNumberOfFaces(); ++i)
    {
      const int* corners = this->Mesh.Faces[static_cast<size_t>(i) / 3].Corners;
      sharing[{ corners[EdgeCorners[i % 3][0]], corners[EdgeCorners[i % 3][1]] }].push_back(i);
    }
    largest = 0.0;
    mean = 0.0;
    int count = 0;
    for (const auto& edge : sharing)
    {
      if (edge.second.size() != 2)
      {
        continue;
      }
      for (double t : { 0.125, 0.3125, 0.5, 0.75, 0.875 })
      {
        Vector normals[2];
        for (int k = 0; k < 2; ++k)
        {
          const int i = edge.second[k];
          Vector w = { { 0.0, 0.0, 0.0 } };
          w[EdgeCorners[i % 3][0]] = 1.0 - t;
          w[EdgeCorners[i % 3][1]] = t;
          normals[k] = this->MeasureEdgeNormal(i / 3, i % 3, t, this->GetNormal(i / 3, w));
        }
        const double jump = angle(normals[0], normals[1]);
        largest = std::max(largest, jump);
        mean += jump * jump;
        ++count;
      }
    }
    mean = std::sqrt(mean / count);
  }

private:
  std::array<Vector, 2> Evaluate(int face, const Vector& w) const
  {
    const float weights[3] = { static_cast<float>(w[0]), static_cast<float>(w[1]),
      static_cast<float>(w[2]) };
    float position[3];
    float normal[3];
    this->Evaluator.Evaluate(face, weights, position, normal);
    return { { { { position[0], position[1], position[2] } },
      { { normal[0], normal[1], normal[2] } } } };
  }
  Vector GetDifference(int face, const Vector& w, const Vector& move) const
  {
    return this->GetPoint(face, w + Epsilon * move) - this->GetPoint(face, w - Epsilon * move);
  }
  static Vector Orient(const Vector& normal, const Vector& outside)
  {
    return normalize((dot(normal, outside) < 0.0 ? -1.0 : 1.0) * normal);
  }

  vtkNew<vtkAdaptiveRefinement> Recipe;
  relevo::RefinementMesh Mesh;

public:
  const bool Built;

private:
  relevo::RefinementEvaluator Evaluator;
};

// The patch by its definition: quartic, with six inner points that are blended.
struct QuarticPatch
{
  Vector P[3];
  Vector N[3];

  // Control points of the cubic curve from corner i to j.
  std::array<Vector, 4> getCurve(int i, int j) const
  {
    const Vector edge = this->P[j] - this->P[i];
    return { { this->P[i], this->P[i] + 1.0 / 3.0 * (edge - dot(edge, this->N[i]) * this->N[i]),
      this->P[j] - 1.0 / 3.0 * (edge - dot(edge, this->N[j]) * this->N[j]), this->P[j] } };
  }
  // Control points of the same curve, raised to degree 4.
  std::array<Vector, 5> getQuartic(int i, int j) const
  {
    const std::array<Vector, 4> c = this->getCurve(i, j);
    return { { c[0], 0.25 * c[0] + 0.75 * c[1], 0.5 * c[1] + 0.5 * c[2], 0.75 * c[2] + 0.25 * c[3],
      c[3] } };
  }
  // The inner point near corner i that the edge to j requires.
  Vector getInner(int i, int j) const
  {
    const int k = 3 - i - j;
    const std::array<Vector, 4> c = this->getCurve(i, j);
    const std::array<Vector, 5> q = this->getQuartic(i, j);
    const Vector w[3] = { c[1] - c[0], c[2] - c[1], c[3] - c[2] };
    Vector a[3] = { normalize(cross(this->N[i], w[0])), {}, normalize(cross(this->N[j], w[2])) };
    a[1] = normalize(a[0] + a[2]);
    const Vector first = this->getQuartic(i, k)[1] - 0.5 * (q[0] + q[1]);
    const Vector last = this->getQuartic(j, k)[1] - 0.5 * (q[3] + q[4]);
    const double l[2] = { dot(first, w[0]) / dot(w[0], w[0]), dot(last, w[2]) / dot(w[2], w[2]) };
    const double m[2] = { dot(first, a[0]), dot(last, a[2]) };
    return 0.5 * (q[1] + q[2]) +
      1.0 / 3.0 * (2.0 * l[0] * w[1] + l[1] * w[0] + 2.0 * m[0] * a[1] + m[1] * a[0]);
  }
  Vector getPosition(const Vector& w) const
  {
    Vector p = { { 0.0, 0.0, 0.0 } };
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const std::array<Vector, 5> q = this->getQuartic(i, j);
      p = p + std::pow(w[i], 4) * q[0] + 4 * std::pow(w[i], 3) * w[j] * q[1] +
        6 * std::pow(w[i] * w[j], 2) * q[2] + 4 * w[i] * std::pow(w[j], 3) * q[3];
      if (w[j] + w[k] > 0.0)
      {
        const Vector inner =
          1.0 / (w[j] + w[k]) * (w[j] * this->getInner(i, j) + w[k] * this->getInner(i, k));
        p = p + 12 * w[i] * w[0] * w[1] * w[2] * inner;
      }
    }
    return p;
  }
};

Mesh makeTriangle(const QuarticPatch& patch)
{
  Mesh mesh = FromTriangles({ patch.P[0], patch.P[1], patch.P[2] }, { { { 0, 1, 2 } } });
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (const Vector& normal : patch.N)
  {
    normals->InsertNextTuple(normal.data());
  }
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

// Random triangles with random normals match the formula.
void testFormula(RelevoCheck& check, vtkG1Surface* surface)
{
  std::mt19937 random(9);
  auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  for (int sample = 0; sample < 100; ++sample)
  {
    QuarticPatch patch;
    const Vector corners[3] = { { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 2, 0 } } };
    for (int i = 0; i < 3; ++i)
    {
      patch.P[i] = corners[i] + Vector{ { 0.5 * number(), 0.5 * number(), 0.5 * number() } };
      patch.N[i] = normalize({ { 0.5 * number(), 0.5 * number(), 1.0 } });
    }
    const Patches patches(makeTriangle(patch), surface);
    CHECK(patches.Built);
    for (int i = 0; i <= 8; ++i)
    {
      for (int j = 0; i + j <= 8; ++j)
      {
        const Vector w = { { i / 8.0, j / 8.0, (8 - i - j) / 8.0 } };
        CHECK_LESS(length(patches.GetPoint(0, w) - patch.getPosition(w)), 2e-6);
        if (i > 0 && j > 0 && i + j < 8)
        {
          const Vector normal = patches.GetNormal(0, w);
          CHECK_NEAR(length(normal), 1.0, 1e-6);
          CHECK_GREATER(normal[2], 0.0);
          CHECK_LESS(angle(normal, patches.MeasureNormal(0, w, { { 0, 0, 1 } })), 0.1);
        }
      }
    }
    for (int edge = 0; edge < 3; ++edge)
    {
      for (double t : { 0.125, 0.25, 0.5, 0.625, 0.875 })
      {
        CHECK_CASE(t);
        Vector w = { { 0.0, 0.0, 0.0 } };
        w[EdgeCorners[edge][0]] = 1.0 - t;
        w[EdgeCorners[edge][1]] = t;
        CHECK_LESS(
          angle(patches.GetNormal(0, w), patches.MeasureEdgeNormal(0, edge, t, { { 0, 0, 1 } })),
          0.2);
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      Vector w = { { 0.0, 0.0, 0.0 } };
      w[i] = 1.0;
      CHECK_LESS(length(patches.GetPoint(0, w) - patch.P[i]), 1e-6);
      CHECK_LESS(length(patches.GetNormal(0, w) - patch.N[i]), 1e-6);
    }
  }
}

// A sphere with bumps, computed normals and edges of many lengths.
Mesh makeBumpy()
{
  Mesh mesh = Sphere(16, 12);
  mesh->GetPointData()->SetNormals(nullptr);
  std::mt19937 random(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const double scale = 1.0 + 0.1 * std::sin(8.0 * p[0]) * std::cos(9.0 * p[1] - 7.0 * p[2]);
    for (double& c : p)
    {
      c = c * scale + 0.02 * (random() / 2147483648.0 - 1.0);
    }
    mesh->GetPoints()->SetPoint(i, p);
  }
  return mesh;
}

// Tangent planes join where those of PN triangles do not.
void testJumps(RelevoCheck& check, vtkG1Surface* surface)
{
  vtkNew<vtkPNTriangleSurface> pn;
  std::vector<std::pair<std::string, Mesh>> meshes = { { "sphere", Sphere(8, 6) },
    { "torus", Torus() }, { "bumpy", makeBumpy() } };
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string bunny = std::string(data ? data : "") + "/mesh/bunny.ply";
  if (std::ifstream(bunny))
  {
    vtkNew<vtkPLYReader> reader;
    reader->SetFileName(bunny.c_str());
    reader->Update();
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputConnection(reader->GetOutputPort());
    decimation->SetTargetReduction(1.0 - 1500.0 / reader->GetOutput()->GetNumberOfPolys());
    decimation->Update();
    meshes.push_back({ "bunny", decimation->GetOutput() });
  }
  for (const auto& mesh : meshes)
  {
    const Patches g1Patches(mesh.second, surface);
    const Patches pnPatches(mesh.second, pn);
    CHECK(g1Patches.Built && pnPatches.Built);
    double largest[2];
    double mean[2];
    pnPatches.MeasureJumps(largest[0], mean[0]);
    g1Patches.MeasureJumps(largest[1], mean[1]);
    std::cout << mesh.first << ": normals differ by " << largest[0] << " degrees at most, "
              << mean[0] << " RMS (PN); " << largest[1] << ", " << mean[1] << " (G1)\n";
    CHECK_GREATER(largest[0], 5.0);
    // Decimated scans have normals along edges. There the patch avoids large bends instead.
    CHECK(largest[1] < 0.2 || mesh.first == "bunny");
    CHECK_LESS(mean[1], 0.02 * mean[0]);
  }
}

// Edges are identical to those of PN triangles, bit for bit.
void testEdges(RelevoCheck& check, vtkG1Surface* surface)
{
  vtkNew<vtkPNTriangleSurface> pn;
  Mesh split = Explode(Sphere(8, 6));
  PerturbNormals(split, 3, 0.8);
  for (const Mesh& mesh : { Sphere(8, 6), split })
  {
    const Patches g1Patches(mesh, surface);
    const Patches pnPatches(mesh, pn);
    for (int face = 0; face < g1Patches.GetNumberOfFaces(); ++face)
    {
      for (int k = 0; k <= 24; ++k)
      {
        Vector w = { { 0.0, 0.0, 0.0 } };
        w[k % 3] = k / 24.0;
        w[(k + 1) % 3] = 1.0 - k / 24.0;
        CHECK_EQUAL(g1Patches.GetPoint(face, w), pnPatches.GetPoint(face, w));
      }
    }
  }
}

// Flat meshes and the faces of a cube with split normals stay flat.
void testPlanes(RelevoCheck& check, vtkG1Surface* surface)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  recipe->SetSurface(surface);
  Mesh plane = Refine(Plane(3, 2), recipe);
  vtkNew<vtkAdaptiveRefinement> linear;
  linear->SetMaximumLevel(4);
  Mesh flat = Refine(Plane(3, 2), linear);
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(plane->GetPoint(i)[2], 0.0);
    CHECK_EQUAL(plane->GetPointData()->GetNormals()->GetComponent(i, 2), 1.0);
    CHECK_NEAR(plane->GetPoint(i)[0], flat->GetPoint(i)[0], 1e-6);
    CHECK_NEAR(plane->GetPoint(i)[1], flat->GetPoint(i)[1], 1e-6);
  }
  Mesh cube = Refine(Cube(), recipe);
  CHECK_EQUAL(cube->GetNumberOfPolys(), 12 * 256);
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    const double* p = cube->GetPoint(i);
    const double* n = cube->GetPointData()->GetNormals()->GetTuple(i);
    CHECK_NEAR(vtkMath::Dot(p, n), 0.5, 1e-6);
    CHECK_NEAR(std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) }), 1.0, 1e-6);
  }
}

// Normals that no surface has: along edges, opposite to each other, flipped, or zero.
void testHostile(RelevoCheck& check, vtkG1Surface* surface)
{
  const std::vector<Vector> directions = { { { 1, 0, 0 } }, { { -1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, 0, 1 } }, { { 0, 0, -1 } }, normalize({ { 1, -1, 0 } }), normalize({ { 1, 1, 0.1 } }),
    normalize({ { -1, 0.001, 0.001 } }) };
  const std::vector<std::array<Vector, 3>> triangles = {
    { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } } },
    { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } } } },
    { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0.5, 1e-5, 0 } } } }
  };
  for (double size : { 1e-20, 1.0, 1e15 })
  {
    for (const auto& triangle : triangles)
    {
      for (size_t kind = 0; kind < 8 * 8 * 8; ++kind)
      {
        QuarticPatch patch;
        for (int i = 0; i < 3; ++i)
        {
          patch.P[i] = size * triangle[i];
          patch.N[i] = directions[(kind >> (3 * i)) % 8];
        }
        const Patches patches(makeTriangle(patch), surface);
        for (int i = 0; i <= 8; ++i)
        {
          for (int j = 0; i + j <= 8; ++j)
          {
            const Vector w = { { i / 8.0, j / 8.0, (8 - i - j) / 8.0 } };
            const Vector normal = patches.GetNormal(0, w);
            const double distance = length(patches.GetPoint(0, w));
            CHECK_LESS(distance, 6.0 * size); // fails for NaN too
            CHECK_LESS(length(normal), 1.001);
          }
        }
      }
    }
  }
  // Normals of zero length are computed from faces, but degenerate triangles have none either.
  QuarticPatch none;
  none.P[0] = none.P[1] = none.P[2] = { { 0, 0, 0 } };
  none.P[1][0] = 1.0;
  none.P[2][0] = 3.0;
  none.N[0] = none.N[1] = none.N[2] = { { 0, 0, 0 } };
  const Patches patches(makeTriangle(none), surface);
  CHECK_LESS(length(patches.GetPoint(0, { { 0.25, 0.25, 0.5 } })), 3.0);
  CHECK_LESS(length(patches.GetNormal(0, { { 0.25, 0.25, 0.5 } })), 1.001);
}
}

int TestG1Surface(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkG1Surface> surface;
  testPlanes(check, surface);
  testHostile(check, surface);
  surface->GeometricNormalsOn();
  testFormula(check, surface);
  testJumps(check, surface);
  testEdges(check, surface);
  testPlanes(check, surface);
  testHostile(check, surface);
  CHECK(surface->NeedsNormals());
  CHECK_NOT_EQUAL(
    surface->GetShaderSource().find("vec3 surfacePosition(vec3 w)"), std::string::npos);
  CHECK_NOT_EQUAL(surface->GetShaderSource().find("vec3 surfaceNormal(vec3 w)"), std::string::npos);
  return check.GetResult();
}
