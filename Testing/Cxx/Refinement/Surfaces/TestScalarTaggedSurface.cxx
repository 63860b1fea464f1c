// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkScalarTaggedSurface promises creases, cusps, tension and bias by its formulae. Control points
// and normals are compared with values computed by hand; creases and cusps on several meshes.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoVector.h"
#include "RelevoWatertight.h"

#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "vtkIdList.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkScalarTaggedSurface.h"

#include <iostream>

using namespace RelevoMeshes;
using namespace RelevoVectors;

namespace
{
Vector toVector(const float* v)
{
  return { { v[0], v[1], v[2] } };
}

struct Tags
{
  double Sharpness = 0.0;
  double Tension = 0.0;
  double Bias = 0.0;
  Vector Direction = { { 0.0, 0.0, 0.0 } };
};

void setTags(vtkPolyData* mesh, vtkIdType point, const Tags& tags)
{
  vtkPointData* data = mesh->GetPointData();
  if (!data->HasArray("Sharpness"))
  {
    AddScalarTags(mesh, "Sharpness");
    AddScalarTags(mesh, "Tension");
    AddScalarTags(mesh, "Bias");
    AddScalarTags(mesh, "Direction", 3);
  }
  data->GetArray("Sharpness")->SetTuple1(point, tags.Sharpness);
  data->GetArray("Tension")->SetTuple1(point, tags.Tension);
  data->GetArray("Bias")->SetTuple1(point, tags.Bias);
  data->GetArray("Direction")->SetTuple(point, tags.Direction.data());
}

// The edge leads from the origin, with normal z, to (3, 0, -3). So e . N = -3, and its tangential
// part is (3, 0, 0).
struct EdgeCase
{
  Tags At;
  Vector Control; // control point near the origin
  Vector Normal;  // normal at the origin for this edge, of any length
  Vector OtherNormal = { { 0, 0, 1 } };
};

const double C30 = std::sqrt(0.75);

const EdgeCase EdgeCases[] = {
  { {}, { { 1, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, 0.5, 0, {} }, { { 0.5, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, 1, 0, {} }, { { 0, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, -1, 0, {} }, { { 2, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, 0, 1, {} }, { { 1, 0, 1 } }, { { -1, 0, 1 } } },
  { { 0, 0, 0.5, {} }, { { 1, 0, 0.5 } }, { { -0.5, 0, 1 } } },
  { { 0, 0, -1, {} }, { { 1, 0, -1 } }, { { 1, 0, 1 } } },
  { { 1, 0, 0, {} }, { { 1, 0, -1 } }, { { 1, 0, 1 } } },
  { { 0.25, 0, 0, {} }, { { 1, 0, -0.25 } }, { { 0.25, 0, 1 } } },
  // The directions lie along the edge, across it, and at 30, 45 and 60 degrees; some have other
  // lengths, a part along the normal, or only that part.
  { { 1, 0, 0, { { 2, 0, 0 } } }, { { 1, 0, 0 } }, { { 0, 0, 1 } } },
  { { 1, 0, 0, { { -3, 0, 0 } } }, { { 1, 0, 0 } }, { { 0, 0, 1 } } },
  { { 1, 0, 0, { { 1, 0, 5 } } }, { { 1, 0, 0 } }, { { 0, 0, 1 } } },
  { { 1, 0, 0, { { 0, 9, 0 } } }, { { 1, 0, -1 } }, { { 1, 0, 1 } } },
  { { 1, 0, 0, { { 0, 0, 7 } } }, { { 1, 0, -1 } }, { { 1, 0, 1 } } },
  // Here s = 0.5, and the slope is 0.5 x / |x|^2 with x = (1/4, -C30 / 2, 0).
  { { 1, 0, 0, { { C30, 0.5, 0 } } }, { { 1, 0, -0.5 } }, { { 0.5, -C30, 1 } } },
  { { 1, 0, 0, { { 0.7, 0.7, 0 } } }, { { 1, 0, -1 } }, { { 1, -1, 1 } } },
  { { 1, 0, 0, { { 0.5, C30, 0 } } }, { { 1, 0, -1 } }, { { 1, -0.5 / C30, 1 } } },
  // The other end's normal is rotated: (t . D) (Nj . D) / (1 + Ni . Nj) = 3 C30 0.6 C30 / 1.8 =
  // 0.75, so hx = -2.25 and again s = 0.5. It has no effect without a direction or across it.
  { { 1, 0, 0, { { C30, 0.5, 0 } } }, { { 1, 0, -0.375 } }, { { 0.375, -0.75 * C30, 1 } },
    { { 0.6, 0, 0.8 } } },
  { { 1, 0, 0, { { 0, 1, 0 } } }, { { 1, 0, -1 } }, { { 1, 0, 1 } }, { { 0.6, 0, 0.8 } } },
  { { 1, 0, 0, {} }, { { 1, 0, -1 } }, { { 1, 0, 1 } }, { { 0.6, 0, 0.8 } } },
  { { 0.5, 0.5, 0.5, {} }, { { 0.5, 0, -0.125 } }, { { 0.25, 0, 1 } } },
  // These tags are out of range and are clamped.
  { { 7, 0, 0, {} }, { { 1, 0, -1 } }, { { 1, 0, 1 } } },
  { { -7, 0, 0, {} }, { { 1, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, 7, 0, {} }, { { 0, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, -7, 0, {} }, { { 2, 0, 0 } }, { { 0, 0, 1 } } },
  { { 0, 0, 7, {} }, { { 1, 0, 1 } }, { { -1, 0, 1 } } },
  { { 0, 0, -7, {} }, { { 1, 0, -1 } }, { { 1, 0, 1 } } },
};

void testControlPoints(RelevoCheck& check)
{
  Mesh mesh =
    FromTriangles({ { { 0, 0, 0 } }, { { 3, 0, -3 } }, { { 0, 3, -1 } } }, { { { 0, 1, 2 } } });
  const auto normals = AddScalarTags(mesh, "Normals", 3);
  for (int i = 0; i < 3; ++i)
  {
    normals->SetTuple3(i, 0, 0, 1);
  }
  mesh->GetPointData()->SetNormals(normals);
  vtkNew<vtkScalarTaggedSurface> surface;
  const auto recipe = MakeRecipe(3, surface);
  int number = 0;
  for (const auto& one : EdgeCases)
  {
    setTags(mesh, 0, one.At);
    normals->SetTuple(1, one.OtherNormal.data());
    mesh->Modified();
    relevo::RefinementMesh prepared;
    CHECK(prepared.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
    // Edge 0 leads from point 0 to point 1. The face's nine edge vectors and its centre come before
    // its normals, and the first normal is that of corner 0 for edge 0. If the edge runs along the
    // direction, the face takes the normal of its other edge, which is not checked here.
    const Vector control = toVector(&prepared.Vectors[0]);
    const Vector normal = toVector(&prepared.Vectors[3 * 10]);
    const bool along = one.At.Direction[0] > one.At.Direction[1] || one.At.Direction[0] < 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const Vector expected = normalize(one.Normal);
      const bool same =
        check.Near(control[c], one.Control[c], 1e-6, "control point", __FILE__, __LINE__);
      const bool sameNormal =
        along || check.Near(normal[c], expected[c], 1e-6, "normal", __FILE__, __LINE__);
      if (!same || !sameNormal)
      {
        check.Fail(__FILE__, __LINE__, "case " + std::to_string(number));
      }
    }
    // The other end, which has no tags, is unchanged.
    const Vector otherControl = toVector(&prepared.Vectors[3]);
    CHECK_NEAR(dot(otherControl - Vector{ { 3, 0, -3 } }, one.OtherNormal), 0.0, 1e-6);
    ++number;
  }
}

// The roof z = -0.5 |x| over a grid. The points with x = 0 are its ridge.
Mesh makeRoof()
{
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (int j = 0; j < 5; ++j)
  {
    for (int i = -2; i <= 2; ++i)
    {
      points.push_back({ { 1.0 * i, 1.0 * j, -0.5 * std::abs(i) } });
      const vtkIdType at = static_cast<vtkIdType>(points.size()) - 1;
      if (i < 2 && j < 4)
      {
        triangles.push_back({ { at, at + 1, at + 6 } });
        triangles.push_back({ { at, at + 6, at + 5 } });
      }
    }
  }
  return FromTriangles(points, triangles);
}

Mesh makeTaggedRoof(double sharpness)
{
  Mesh roof = makeRoof();
  for (vtkIdType i = 0; i < roof->GetNumberOfPoints(); ++i)
  {
    setTags(roof, i, { roof->GetPoint(i)[0] == 0.0 ? sharpness : 0.0, 0, 0, { { 0, 1, 0 } } });
  }
  return roof;
}

// Distances of refined points from the roof, and deviations of normals from those of its sides.
void getRoofErrors(vtkPolyData* refined, double& distance, double& deviation)
{
  distance = deviation = 0.0;
  const double c = 1.0 / std::sqrt(1.25);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    refined->GetCellPoints(cell, ids);
    double side = 0.0;
    for (vtkIdType k = 0; k < 3; ++k)
    {
      side += refined->GetPoint(ids->GetId(k))[0];
    }
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const double* p = refined->GetPoint(ids->GetId(k));
      distance = std::max(distance, std::abs(p[2] + 0.5 * std::abs(p[0])));
      Vector normal;
      refined->GetPointData()->GetNormals()->GetTuple(ids->GetId(k), normal.data());
      const Vector expected = { { side > 0.0 ? 0.5 * c : -0.5 * c, 0.0, c } };
      deviation = std::max(deviation, length(normal - expected));
    }
  }
}

void testRoof(RelevoCheck& check)
{
  vtkNew<vtkScalarTaggedSurface> surface;
  const auto recipe = MakeRecipe(4, surface);
  double distance;
  double deviation;
  Mesh rounded = Refine(makeRoof(), recipe);
  getRoofErrors(rounded, distance, deviation);
  CHECK_GREATER(distance, 0.05);
  CHECK_GREATER(deviation, 0.4);
  CHECK_EQUAL(rounded->GetNumberOfPoints(), 65 * 65);

  Mesh roof = makeTaggedRoof(1.0);
  Mesh sharp = Refine(roof, recipe);
  getRoofErrors(sharp, distance, deviation);
  CHECK_LESS(distance, 1e-6);
  CHECK_LESS(deviation, 1e-5);
  // Points on the ridge exist twice, with the same data.
  CHECK_EQUAL(sharp->GetNumberOfPoints(), 65 * 65 + 65);
  CHECK(RelevoWatertight::FindError(roof, sharp, 4).empty());
  int ridge = 0;
  for (vtkIdType i = 0; i < sharp->GetNumberOfPoints(); ++i)
  {
    const double x = sharp->GetPoint(i)[0];
    CHECK_NEAR(sharp->GetPointData()->GetArray("Sharpness")->GetTuple1(i),
      std::max(0.0, 1.0 - std::abs(x)), 1e-6);
    ridge += x == 0.0 ? 1 : 0;
  }
  CHECK_EQUAL(ridge, 130);

  // With half the sharpness, errors lie in between.
  Mesh half = Refine(makeTaggedRoof(0.5), recipe);
  getRoofErrors(half, distance, deviation);
  CHECK_GREATER(distance, 0.02);
  CHECK_LESS(distance, 0.05);
  CHECK_GREATER(deviation, 0.1);
  CHECK_LESS(deviation, 0.4);

  // All triangles have separate points, and directions point both ways.
  Mesh open = Refine(roof, MakeRecipe(0, nullptr));
  vtkNew<vtkPNTriangleSurface> withNormals;
  open = Refine(roof, MakeRecipe(0, withNormals));
  Mesh exploded = Explode(open);
  for (vtkIdType i = 0; i < exploded->GetNumberOfPoints(); ++i)
  {
    setTags(exploded, i,
      { exploded->GetPoint(i)[0] == 0.0 ? 1.0 : 0.0, 0, 0, { { 0, i % 2 ? 1.0 : -1.0, 0 } } });
  }
  getRoofErrors(Refine(exploded, recipe), distance, deviation);
  CHECK_LESS(distance, 1e-6);
  CHECK_LESS(deviation, 1e-5);
}

struct EdgeSample
{
  std::array<float, 3> Position;
  std::array<float, 3> Normal;
};

// Samples inside each edge, by each of its faces, with the edge's two points as key.
std::map<std::pair<int, int>, std::vector<std::vector<EdgeSample>>> sampleEdges(
  const relevo::RefinementMesh& mesh, const relevo::RefinementEvaluator& evaluator)
{
  std::map<std::pair<int, int>, std::vector<std::vector<EdgeSample>>> edges;
  for (int face = 0; face < static_cast<int>(mesh.Faces.size()); ++face)
  {
    for (const auto& edge : relevo::EdgeCorners)
    {
      std::vector<EdgeSample> samples(15);
      for (size_t k = 0; k < samples.size(); ++k)
      {
        float weights[3] = { 0.0f, 0.0f, 0.0f };
        weights[edge[1]] = static_cast<float>(k + 1) / 16.0f;
        weights[edge[0]] = 1.0f - weights[edge[1]];
        evaluator.Evaluate(face, weights, samples[k].Position.data(), samples[k].Normal.data());
      }
      const int* corners = mesh.Faces[face].Corners;
      edges[{ corners[edge[0]], corners[edge[1]] }].push_back(samples);
    }
  }
  return edges;
}

// The equator of a sphere is a crease: normals jump across it, and nowhere else.
void testCrease(RelevoCheck& check)
{
  Mesh sphere = Sphere(12, 7); // an odd number of rings, so that one is the equator
  std::vector<bool> onEquator;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double* p = sphere->GetPoint(i);
    onEquator.push_back(std::abs(p[2]) < 1e-6);
    setTags(sphere, i, { onEquator.back() ? 1.0 : 0.0, 0, 0, { { -p[1], p[0], 0 } } });
  }
  CHECK_EQUAL(std::count(onEquator.begin(), onEquator.end(), true), 12);
  vtkNew<vtkScalarTaggedSurface> surface;
  const auto recipe = MakeRecipe(4, surface);
  relevo::RefinementMesh mesh;
  CHECK(mesh.Build(sphere, recipe->GetSurface(), recipe->GetDisplacement()));
  const relevo::RefinementEvaluator evaluator(mesh, recipe);
  int creases = 0;
  for (const auto& edge : sampleEdges(mesh, evaluator))
  {
    CHECK_EQUAL(edge.second.size(), 2);
    const bool isCrease = onEquator[edge.first.first] && onEquator[edge.first.second];
    creases += isCrease ? 1 : 0;
    for (size_t k = 0; k < edge.second[0].size(); ++k)
    {
      const EdgeSample& a = edge.second[0][k];
      const EdgeSample& b = edge.second[1][k];
      CHECK_EQUAL(a.Position, b.Position);
      if (!isCrease)
      {
        CHECK_EQUAL(a.Normal, b.Normal);
        continue;
      }
      // The planes of faces at the equator meet at 30 degrees.
      const double jump = angle(toVector(a.Normal.data()), toVector(b.Normal.data()));
      CHECK_GREATER(jump, 20.0);
      CHECK_LESS(jump, 40.0);
    }
  }
  CHECK_EQUAL(creases, 12);

  // Normals fit the refined triangles, up to the angle between a triangle and its corners' normals.
  const Mesh refined = Refine(sphere, recipe);
  CHECK(RelevoWatertight::FindError(sphere, refined, 4).empty());
  vtkNew<vtkIdList> ids;
  double most = 0.0;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    refined->GetCellPoints(cell, ids);
    Vector p[3];
    for (vtkIdType k = 0; k < 3; ++k)
    {
      refined->GetPoint(ids->GetId(k), p[k].data());
    }
    const Vector facet = cross(p[1] - p[0], p[2] - p[0]);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      Vector normal;
      refined->GetPointData()->GetNormals()->GetTuple(ids->GetId(k), normal.data());
      most = std::max(most, angle(facet, normal));
    }
  }
  std::cout << "Normals and refined triangles differ by at most " << most << " degrees"
            << std::endl;
  CHECK_LESS(most, 12.0);
}

// At the tip of half an octahedron, sharpness without a direction lets the surface leave along the
// edges, and normals are those of a cone. The tangents of PN triangles lie in one plane.
void testCusp(RelevoCheck& check)
{
  for (bool sharp : { false, true })
  {
    Mesh tent = FromTriangles(
      { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0, 0 } }, { { 0, -1, 0 } }, { { 0, 0, 1 } } },
      { { { 0, 1, 4 } }, { { 1, 2, 4 } }, { { 2, 3, 4 } }, { { 3, 0, 4 } } });
    setTags(tent, 4, { sharp ? 1.0 : 0.0, 0, 0, {} });
    vtkNew<vtkScalarTaggedSurface> surface;
    const auto recipe = MakeRecipe(3, surface);
    relevo::RefinementMesh mesh;
    CHECK(mesh.Build(tent, recipe->GetSurface(), recipe->GetDisplacement()));
    const relevo::RefinementEvaluator evaluator(mesh, recipe);
    std::vector<Vector> tangents;
    const double pi = vtkMath::Pi();
    for (int face = 0; face < 4; ++face)
    {
      // The tip is the last of the sorted corners. It is evaluated close to the first edge.
      const float weights[3] = { 1.0f / 4096.0f, 0.0f, 4095.0f / 4096.0f };
      float position[3];
      float normal[3];
      evaluator.Evaluate(face, weights, position, normal);
      const Vector tangent = normalize(toVector(position) - Vector{ { 0, 0, 1 } });
      CHECK_NEAR(tangent[2], sharp ? -std::sin(0.25 * pi) : 0.0, 2e-3);
      CHECK_NEAR(normal[2], sharp ? std::sin(0.25 * pi) : 1.0, 2e-3);
      CHECK_NEAR(dot(tangent, toVector(normal)), 0.0, 2e-3);
      tangents.push_back(tangent);
    }
    CHECK_NEAR(std::abs(dot(cross(tangents[0], tangents[1]), tangents[2])),
      sharp ? std::sqrt(0.5) : 0.0, 0.01);
    // Each face has a separate point at the tip, with a separate normal.
    const Mesh refined = Refine(tent, recipe);
    CHECK_EQUAL(refined->GetNumberOfPoints(), 145 + (sharp ? 3 : 0));
    CHECK(RelevoWatertight::FindError(tent, refined, 3).empty());
  }
}

// A crease at a single point fades: normals agree at the far ends of its edges.
void testFading(RelevoCheck& check)
{
  Mesh roof = makeRoof();
  setTags(roof, 12, { 1, 0, 0, { { 0, 1, 0 } } }); // inside the ridge
  vtkNew<vtkScalarTaggedSurface> surface;
  const auto recipe = MakeRecipe(4, surface);
  relevo::RefinementMesh mesh;
  CHECK(mesh.Build(roof, recipe->GetSurface(), recipe->GetDisplacement()));
  const relevo::RefinementEvaluator evaluator(mesh, recipe);
  const auto edges = sampleEdges(mesh, evaluator);
  const auto getJump = [](const std::vector<std::vector<EdgeSample>>& edge, size_t k)
  { return length(toVector(edge[0][k].Normal.data()) - toVector(edge[1][k].Normal.data())); };
  const auto& crease = edges.at({ 12, 17 });
  CHECK_GREATER(getJump(crease, 0), 0.7);
  CHECK_LESS(getJump(crease, 14), 0.1);
  CHECK_EQUAL(getJump(edges.at({ 17, 22 }), 7), 0.0);
}

// Extreme values in the allowed range, on a closed mesh.
void testExtremes(RelevoCheck& check)
{
  vtkNew<vtkScalarTaggedSurface> surface;
  const auto recipe = MakeRecipe(3, surface);
  for (int kind = 0; kind < 5 * 5 * 5 * 2; ++kind)
  {
    const double values[5] = { -1.0, 0.0, 1.0, -1e30, 1e30 };
    Mesh sphere = Sphere(6, 5);
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      // Every third point has no tags.
      const double* p = sphere->GetPoint(i);
      setTags(sphere, i,
        i % 3 == 0 ? Tags()
                   : Tags{ values[kind % 5], values[kind / 5 % 5], values[kind / 25 % 5],
                       { { 0.0, kind >= 125 ? 1e30 * p[0] : 0.0, 0.0 } } });
    }
    const Mesh refined = Refine(sphere, recipe);
    relevo::RefinementMesh mesh;
    CHECK(mesh.Build(sphere, recipe->GetSurface(), recipe->GetDisplacement()));
    double bounds[6];
    relevo::ComputeBounds(mesh, recipe->GetSurface(), recipe->GetDisplacement(), bounds);
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      const double* p = refined->GetPoint(i);
      CHECK_LESS(length({ { p[0], p[1], p[2] } }), 2.0);
      for (int c = 0; c < 3; ++c)
      {
        CHECK(p[c] >= bounds[2 * c] - 1e-6 && p[c] <= bounds[2 * c + 1] + 1e-6);
      }
      Vector normal;
      refined->GetPointData()->GetNormals()->GetTuple(i, normal.data());
      CHECK_NEAR(length(normal), 1.0, 1e-5);
    }
    CHECK(RelevoWatertight::FindError(sphere, refined, 3).empty());
  }
}
}

int TestScalarTaggedSurface(int, char*[])
{
  RelevoCheck check;
  testControlPoints(check);
  testRoof(check);
  testCrease(check);
  testCusp(check);
  testFading(check);
  testExtremes(check);
  return check.GetResult();
}
