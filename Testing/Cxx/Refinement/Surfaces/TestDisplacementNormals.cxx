// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDisplacement promises: shading normals follow the height gradient. The test compares them with
// analytic normals and with normals of the refined faces, and a mesh in pieces with the whole mesh.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDisplacement.h"
#include "vtkMath.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"

#include <cmath>
#include <iostream>
#include <map>
#include <random>

using namespace RelevoMeshes;

namespace
{
using Vector = std::array<double, 3>;

double degreesBetween(const double* a, const double* b)
{
  return vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(a, b));
}

constexpr double Waves = 2.0 * 3.14159265358979323846;

double wave(double u, double v)
{
  return std::sin(Waves * u) * std::cos(Waves * v);
}

// Planes of every orientation with affine texture coordinates, displaced along the normal or a
// fixed direction.
void testPlane(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(256, 256, wave);
  std::mt19937 random(4);
  auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  for (int sample = 0; sample < 12; ++sample)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetResolution(5, 4);
    const Vector origin = { { number(), number(), number() } };
    const Vector x = { { 1.0 + number(), number(), number() } };
    const Vector y = { { number(), 1.5 + number(), number() } };
    source->SetOrigin(origin[0], origin[1], origin[2]);
    source->SetPoint1(origin[0] + x[0], origin[1] + x[1], origin[2] + x[2]);
    source->SetPoint2(origin[0] + y[0], origin[1] + y[1], origin[2] + y[2]);
    source->Update();
    Mesh mesh = Make();
    mesh->DeepCopy(source->GetOutput());
    // Texture coordinates are u = A s + B t + C of the plane's coordinates (s, t).
    double uv[2][3];
    for (int i = 0; i < 2; ++i)
    {
      uv[i][0] = 0.35 * number();
      uv[i][1] = 0.35 * number();
      uv[i][2] = 0.5 - 0.5 * (uv[i][0] + uv[i][1]);
    }
    vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double st[2];
      coordinates->GetTuple(i, st);
      coordinates->SetTuple2(i, uv[0][0] * st[0] + uv[0][1] * st[1] + uv[0][2],
        uv[1][0] * st[0] + uv[1][1] * st[1] + uv[1][2]);
    }
    const double scale = 0.1 + 0.1 * number();
    auto displacement = MakeDisplacement(heights, scale, 0.3);
    Vector direction;
    mesh->GetPointData()->GetNormals()->GetTuple(0, direction.data());
    if (sample % 2)
    {
      for (double& c : direction)
      {
        c += 0.5 * number();
      }
      vtkMath::Normalize(direction.data());
      displacement->SetDirection(direction.data());
    }
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetDisplacement(displacement);
    recipe->SetMaximumLevel(3);
    Mesh refined = Refine(mesh, recipe);
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      double c[2];
      refined->GetPointData()->GetTCoords()->GetTuple(i, c);
      const double u = Waves * c[0];
      const double v = Waves * c[1];
      const double hu = scale * Waves * std::cos(u) * std::cos(v);
      const double hv = -scale * Waves * std::sin(u) * std::sin(v);
      Vector s;
      Vector t;
      for (int k = 0; k < 3; ++k)
      {
        s[k] = x[k] + direction[k] * (hu * uv[0][0] + hv * uv[1][0]);
        t[k] = y[k] + direction[k] * (hu * uv[0][1] + hv * uv[1][1]);
      }
      Vector normal;
      vtkMath::Cross(s.data(), t.data(), normal.data());
      CHECK_LESS(
        degreesBetween(normal.data(), refined->GetPointData()->GetNormals()->GetTuple(i)), 0.2);
    }
  }
}

// With constant heights a sphere grows and its normals stay.
void testOffset(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(3, 3, [](double, double) { return 0.2; });
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  displacement->SetOffset(0.1);
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(3);
  recipe->SetDisplacement(displacement);
  recipe->SetSurface(pn);
  Mesh sphere = Sphere(24, 16);
  AddTextureCoordinates(sphere,
    [](const double* p) {
      return std::array<double, 2>{ { p[0] + 0.5, p[1] + 0.5 } };
    });
  Mesh refined = Refine(sphere, recipe);
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const double* p = refined->GetPoint(i);
    CHECK_NEAR(vtkMath::Norm(p), 0.8, 2e-3);
    // The quadratic normals of PN triangles already deviate by about one degree here.
    CHECK_LESS(degreesBetween(p, refined->GetPointData()->GetNormals()->GetTuple(i)), 1.5);
  }
}

struct Deviation
{
  double Mean = 0.0;
  double Largest = 0.0;
};

// Compares the output's normals with those of its faces, matched by point.
Deviation compareWithFaces(vtkPolyData* refined, double margin)
{
  vtkNew<vtkPolyDataNormals> faces;
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(refined->GetPoints());
  bare->SetPolys(refined->GetPolys());
  faces->SetInputData(bare);
  faces->SplittingOff();
  faces->ConsistencyOff();
  faces->Update();
  Deviation result;
  int count = 0;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    double uv[2];
    refined->GetPointData()->GetTCoords()->GetTuple(i, uv);
    if (uv[0] < margin || uv[0] > 1.0 - margin || uv[1] < margin || uv[1] > 1.0 - margin)
    {
      continue; // at seams and poles, faces lie on one side only
    }
    const double degrees = degreesBetween(refined->GetPointData()->GetNormals()->GetTuple(i),
      vtkPolyData::SafeDownCast(faces->GetOutputDataObject(0))
        ->GetPointData()
        ->GetNormals()
        ->GetTuple(i));
    result.Mean += degrees;
    result.Largest = std::max(result.Largest, degrees);
    ++count;
  }
  result.Mean /= count;
  return result;
}

Vector getSpherePoint(double u, double v)
{
  const double a = 2.0 * vtkMath::Pi() * u;
  const double b = vtkMath::Pi() * (v - 0.5);
  return { { 0.5 * std::cos(a) * std::cos(b), 0.5 * std::sin(a) * std::cos(b),
    0.5 * std::sin(b) } };
}

Vector getCylinderPoint(double u, double v)
{
  const double a = 2.0 * vtkMath::Pi() * u;
  return { { 0.5 * std::cos(a), 0.5 * std::sin(a), 2.0 * v } };
}

Vector getTorusPoint(double u, double v)
{
  const double a = 2.0 * vtkMath::Pi() * u;
  const double b = 2.0 * vtkMath::Pi() * v;
  const double r = 1.0 + 0.4 * std::cos(b);
  return { { r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b) } };
}

using Shape = Vector (*)(double u, double v);

// A grid over [0, 1]^2 with a seam. Normals come from differences.
Mesh makeGrid(Shape shape)
{
  const int nu = 32;
  const int nv = 24;
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  vtkNew<vtkFloatArray> uvs;
  uvs->SetNumberOfComponents(2);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int j = 0; j <= nv; ++j)
  {
    for (int i = 0; i <= nu; ++i)
    {
      const double u = static_cast<double>(i) / nu;
      const double v = 0.1 + 0.8 * j / nv;
      points.push_back(shape(u, v));
      uvs->InsertNextTuple2(u, v);
      const double e = 1e-5;
      Vector du = shape(u + e, v);
      Vector dv = shape(u, v + e);
      vtkMath::Subtract(du, points.back(), du);
      vtkMath::Subtract(dv, points.back(), dv);
      Vector n;
      vtkMath::Cross(du.data(), dv.data(), n.data());
      vtkMath::Normalize(n.data());
      normals->InsertNextTuple(n.data());
      if (i < nu && j < nv)
      {
        const vtkIdType a = j * (nu + 1) + i;
        triangles.push_back({ { a, a + 1, a + nu + 2 } });
        triangles.push_back({ { a, a + nu + 2, a + nu + 1 } });
      }
    }
  }
  Mesh mesh = FromTriangles(points, triangles);
  mesh->GetPointData()->SetTCoords(uvs);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

// Normals follow bumps on spheres, cylinders and tori.
void testBumps(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(256, 256, [](double u, double v) { return wave(3.0 * u, 2.0 * v); });
  auto displacement = MakeDisplacement(heights, 0.04, 0.05);
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  recipe->SetDisplacement(displacement);
  recipe->SetSurface(pn);
  const std::pair<const char*, Shape> shapes[] = { { "sphere", getSpherePoint },
    { "cylinder", getCylinderPoint }, { "torus", getTorusPoint } };
  for (const auto& shape : shapes)
  {
    Mesh mesh = makeGrid(shape.second);
    Mesh bumpy = Refine(mesh, recipe);
    const Deviation deviation = compareWithFaces(bumpy, 0.15);
    std::cout << shape.first << ": normals deviate by " << deviation.Mean << " degrees on average, "
              << deviation.Largest << " at most\n";
    // This is the error without the heights, for comparison.
    recipe->SetDisplacement(nullptr);
    Mesh plain = Refine(mesh, recipe);
    recipe->SetDisplacement(displacement);
    Mesh ignorant = Make();
    ignorant->ShallowCopy(bumpy);
    ignorant->GetPointData()->SetNormals(plain->GetPointData()->GetNormals());
    const Deviation ignored = compareWithFaces(ignorant, 0.15);
    std::cout << "  without the height gradient: " << ignored.Mean << " and " << ignored.Largest
              << "\n";
    CHECK_LESS(deviation.Mean, 0.15 * ignored.Mean);
    CHECK_LESS(deviation.Largest, 0.25 * ignored.Largest);
  }
}

// At the edge of a map, no slope is lost or doubled.
void testBorder(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(64, 64, [](double u, double v) { return u + 2.0 * v; });
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetDisplacement(displacement);
  recipe->SetMaximumLevel(3);
  Mesh refined = Refine(Plane(2, 2), recipe);
  const double expected[3] = { -1.0, -2.0, 1.0 };
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    CHECK_LESS(degreesBetween(expected, refined->GetPointData()->GetNormals()->GetTuple(i)), 0.1);
  }
}

// A bent strip over x from first / 16 to last / 16, whose texture coordinate u goes back and forth.
Mesh makeStrip(int first, int last, int firstRow = 0, int lastRow = 2)
{
  const int numberOfRows = lastRow - firstRow + 1;
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  vtkNew<vtkFloatArray> uvs;
  uvs->SetNumberOfComponents(2);
  for (int i = first; i <= last; ++i)
  {
    const double x = i / 16.0;
    for (int j = firstRow; j <= lastRow; ++j)
    {
      points.push_back({ { std::sin(2.0 * x - 1.0), 0.5 * j, std::cos(2.0 * x - 1.0) } });
      uvs->InsertNextTuple2(std::abs(2.0 * x - 1.0), 0.5 * j);
      if (i < last && j < lastRow)
      {
        const vtkIdType a = numberOfRows * (i - first) + j - firstRow;
        triangles.push_back({ { a, a + numberOfRows, a + numberOfRows + 1 } });
        triangles.push_back({ { a, a + numberOfRows + 1, a + 1 } });
      }
    }
  }
  Mesh mesh = FromTriangles(points, triangles);
  mesh->GetPointData()->SetTCoords(uvs);
  return mesh;
}

Mesh append(const std::vector<Mesh>& pieces)
{
  vtkNew<vtkAppendPolyData> all;
  for (const Mesh& piece : pieces)
  {
    all->AddInputData(piece);
  }
  all->Update();
  return all->GetOutput();
}

// A strip in pieces is displaced like the whole strip, with the same normals.
void testPieces(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(64, 64, [](double u, double v) { return std::sin(9.0 * u) + std::cos(7.0 * v); });
  vtkNew<vtkPNTriangleSurface> pn;
  const Mesh whole = makeStrip(0, 16);
  const Mesh halves = append({ makeStrip(0, 8), makeStrip(8, 16) });
  const Mesh quarters =
    append({ makeStrip(0, 4), makeStrip(4, 8), makeStrip(8, 12), makeStrip(12, 16) });
  const Mesh turned = append({ makeStrip(8, 16), makeStrip(4, 8), makeStrip(0, 4) });
  for (vtkRefinementSurface* surface :
    { static_cast<vtkRefinementSurface*>(nullptr), static_cast<vtkRefinementSurface*>(pn.Get()) })
  {
    for (int level = 0; level < 4; ++level)
    {
      const auto recipe = MakeRecipe(level, surface, MakeDisplacement(heights, 0.15));
      std::map<Vector, Vector> normals;
      const Mesh expected = Refine(whole, recipe);
      vtkDataArray* array = expected->GetPointData()->GetNormals();
      for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
      {
        Vector x;
        expected->GetPoint(i, x.data());
        array->GetTuple(i, normals[x].data());
      }
      for (const Mesh& pieces : { halves, quarters })
      {
        const Mesh refined = Refine(pieces, recipe);
        CHECK_GREATER(refined->GetNumberOfPoints(), expected->GetNumberOfPoints());
        for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
        {
          Vector x;
          refined->GetPoint(i, x.data());
          Vector normal;
          refined->GetPointData()->GetNormals()->GetTuple(i, normal.data());
          const auto found = normals.find(x);
          CHECK(found != normals.end() && found->second == normal);
        }
      }
      // In this strip, the ends of edges have the opposite order.
      const Mesh single = Refine(turned, recipe);
      CHECK_EQUAL(single->GetNumberOfCells(), expected->GetNumberOfCells());
      double farthest = 0.0;
      for (vtkIdType i = 0; i < single->GetNumberOfPoints(); ++i)
      {
        Vector x;
        single->GetPoint(i, x.data());
        double nearest = 1.0;
        for (const auto& point : normals)
        {
          nearest = std::min(nearest,
            std::sqrt(vtkMath::Distance2BetweenPoints(point.first.data(), x.data())) +
              std::sqrt(vtkMath::Distance2BetweenPoints(
                point.second.data(), single->GetPointData()->GetNormals()->GetTuple(i))));
        }
        farthest = std::max(farthest, nearest);
      }
      CHECK_LESS(farthest, 2e-6);
    }
  }
}

// The strip has a crease in the middle, where normals and values are split. At a point of the
// crease that several pieces have, direction and value do not depend on the number of pieces.
void testCreasedPieces(RelevoCheck& check)
{
  const auto makeSide = [](int first, int last, int firstRow, int lastRow)
  {
    Mesh side = makeStrip(first, last, firstRow, lastRow);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> alphas;
    alphas->SetName("Alpha");
    for (vtkIdType i = 0; i < side->GetNumberOfPoints(); ++i)
    {
      normals->InsertNextTuple3(first < 8 ? -0.6 : 0.6, 0.0, 0.8);
      alphas->InsertNextValue(first < 8 ? 0.1f : 0.9f);
    }
    side->GetPointData()->SetNormals(normals);
    side->GetPointData()->AddArray(alphas);
    return side;
  };
  const Mesh whole = append({ makeSide(0, 8, 0, 2), makeSide(8, 16, 0, 2) });
  const Mesh pieces = append({ makeSide(0, 8, 0, 1), makeSide(0, 8, 1, 2), makeSide(8, 16, 0, 2) });
  vtkNew<RelevoHeights> heights;
  heights->Fill(64, 64, [](double u, double v) { return 1.0 + u * v; });
  vtkNew<vtkPhongSurface> phong;
  phong->SetAlphaArrayName("Alpha");
  for (const auto& recipe :
    { MakeRecipe(2, nullptr, MakeDisplacement(heights, 0.15)), MakeRecipe(2, phong, nullptr) })
  {
    const Mesh expected = Refine(whole, recipe);
    const Mesh refined = Refine(pieces, recipe);
    CHECK_EQUAL(refined->GetNumberOfCells(), expected->GetNumberOfCells());
    double farthest = 0.0;
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      Vector x;
      refined->GetPoint(i, x.data());
      double nearest = 1.0;
      for (vtkIdType k = 0; k < expected->GetNumberOfPoints(); ++k)
      {
        nearest =
          std::min(nearest, vtkMath::Distance2BetweenPoints(x.data(), expected->GetPoint(k)));
      }
      farthest = std::max(farthest, std::sqrt(nearest));
    }
    CHECK_LESS(farthest, 2e-6);
  }
}

// The two halves of this plane have mirrored texture coordinates, so each side of the seam has its
// own gradient.
void testSeam(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(512, 3, [](double u, double) { return std::cos(Waves * u); });
  const auto makeHalf = [](bool isSecond)
  {
    Mesh half =
      FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } } },
        { { { 0, 1, 2 } }, { { 0, 2, 3 } } });
    for (vtkIdType i = 0; isSecond && i < 4; ++i)
    {
      const double* x = half->GetPoint(i);
      half->GetPoints()->SetPoint(i, x[0] + 1.0, x[1], 0.0);
    }
    AddTextureCoordinates(half,
      [&](const double* x) {
        return std::array<double, 2>{ { isSecond ? 1.0 - 0.25 * x[0] : 0.25 * x[0], x[1] } };
      });
    return half;
  };
  const Mesh plane = append({ makeHalf(false), makeHalf(true) });
  const Mesh refined = Refine(plane, MakeRecipe(4, nullptr, MakeDisplacement(heights, 0.2)));
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const double u = 0.25 * refined->GetPoint(i)[0];
    const double normal[3] = { 0.2 * 0.25 * Waves * std::sin(Waves * u), 0.0, 1.0 };
    const double margin = 1e-3; // the map's ends
    CHECK(u < margin || u > 0.5 - margin ||
      degreesBetween(normal, refined->GetPointData()->GetNormals()->GetTuple(i)) < 0.2);
  }
}

// Texture coordinates continue over the ridge of a roof with split normals. Each side has its own
// gradient.
void testCrease(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(64, 3, [](double u, double) { return u; });
  const double scale = 0.4;
  Vector direction = { { 0.5, 0.2, 0.6 } };
  vtkMath::Normalize(direction.data());
  const auto displacement =
    MakeDisplacementAlong(direction[0], direction[1], direction[2], heights, scale);
  const auto makeSide = [](bool isSecond)
  {
    const auto place = [&](double along, double across) {
      return isSecond ? Vector{ { 1.0, across, -along } } : Vector{ { along, across, 0.0 } };
    };
    Mesh side = FromTriangles(
      { place(0, 0), place(1, 0), place(1, 1), place(0, 1) }, { { { 0, 1, 2 } }, { { 0, 2, 3 } } });
    AddTextureCoordinates(side,
      [&](const double* x) {
        return std::array<double, 2>{ { 0.1 + 0.4 * (x[0] - x[2]), x[1] } };
      });
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (int i = 0; i < 4; ++i)
    {
      normals->InsertNextTuple3(isSecond ? 1.0 : 0.0, 0.0, isSecond ? 0.0 : 1.0);
    }
    side->GetPointData()->SetNormals(normals);
    return side;
  };
  const Mesh refined =
    Refine(append({ makeSide(false), makeSide(true) }), MakeRecipe(3, nullptr, displacement));
  const Mesh flat =
    Refine(append({ makeSide(false), makeSide(true) }), MakeRecipe(3, nullptr, nullptr));
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const double* x = flat->GetPoint(i);
    if (x[0] == 1.0 && x[2] == 0.0)
    {
      continue; // on the ridge
    }
    const bool isSecond = x[2] < 0.0;
    const Vector base = { { isSecond ? 1.0 : 0.0, 0.0, isSecond ? 0.0 : 1.0 } };
    const Vector gradient = { { isSecond ? 0.0 : 0.4 * scale, 0.0,
      isSecond ? -0.4 * scale : 0.0 } };
    Vector normal;
    for (int c = 0; c < 3; ++c)
    {
      normal[c] = base[c] * (1.0 + vtkMath::Dot(gradient.data(), direction.data())) -
        gradient[c] * vtkMath::Dot(base.data(), direction.data());
    }
    CHECK_LESS(
      degreesBetween(normal.data(), refined->GetPointData()->GetNormals()->GetTuple(i)), 0.01);
  }
}
}

int TestDisplacementNormals(int, char*[])
{
  RelevoCheck check;
  testPlane(check);
  testOffset(check);
  testBumps(check);
  testBorder(check);
  testPieces(check);
  testCreasedPieces(check);
  testSeam(check);
  testCrease(check);
  return check.GetResult();
}
