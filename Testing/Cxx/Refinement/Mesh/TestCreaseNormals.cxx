// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCreaseNormals promises: with the surface that it chooses, a mesh keeps its shape (volume,
// bounds and distance), stays closed and keeps its data.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkConeSource.h"
#include "vtkCreaseNormals.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDoubleArray.h"
#include "vtkLinearExtrusionFilter.h"
#include "vtkLinearSurface.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using RelevoMeshes::Mesh;

// Points and polygons of a source's output, with coincident points merged and without data.
Mesh takeShape(vtkAlgorithm* source)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(source->GetOutputPort());
  clean->Update();
  Mesh shape = RelevoMeshes::Make();
  shape->SetPoints(clean->GetOutput()->GetPoints());
  shape->SetPolys(clean->GetOutput()->GetPolys());
  return shape;
}

Mesh makeBlock()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(4.0);
  cube->SetYLength(2.0);
  return takeShape(cube);
}

Mesh makeSphere(int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  return takeShape(sphere);
}

Mesh makeSolid(int type)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidType(type);
  return takeShape(solid);
}

// A slab of 5 x 2 x 3 whose long edges are rounded in steps of 22.5 degrees.
Mesh makeRoundedSlab()
{
  const double radius = 0.2;
  const double centres[4][2] = { { 4.8, 1.8 }, { 0.2, 1.8 }, { 0.2, 0.2 }, { 4.8, 0.2 } };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> outline;
  outline->InsertNextCell(20);
  for (int i = 0; i < 20; ++i)
  {
    const double angle = vtkMath::RadiansFromDegrees(90.0 * (i / 5) + 22.5 * (i % 5));
    outline->InsertCellPoint(points->InsertNextPoint(centres[i / 5][0] + radius * std::cos(angle),
      centres[i / 5][1] + radius * std::sin(angle), 0.0));
  }
  Mesh profile = RelevoMeshes::Make();
  profile->SetPoints(points);
  profile->SetPolys(outline);
  vtkNew<vtkLinearExtrusionFilter> extrusion;
  extrusion->SetInputData(profile);
  extrusion->SetExtrusionTypeToVectorExtrusion();
  extrusion->SetVector(0.0, 0.0, 3.0);
  vtkNew<vtkTriangleFilter> triangles; // triangulates strips
  triangles->SetInputConnection(extrusion->GetOutputPort());
  return takeShape(triangles);
}

double getVolume(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(triangles->GetOutputPort());
  properties->Update();
  return properties->GetVolume();
}

struct Fitted
{
  Mesh Coarse;
  Mesh Refined;
  bool IsLinear;
  vtkIdType NumberOfCreases;
};

Fitted fit(vtkPolyData* mesh, int level = 3)
{
  vtkNew<vtkCreaseNormals> normals;
  normals->SetInputData(mesh);
  normals->Update();
  Fitted result;
  result.Coarse = normals->GetOutput();
  result.IsLinear = vtkLinearSurface::SafeDownCast(normals->GetFittingSurface()) != nullptr;
  result.NumberOfCreases = normals->GetNumberOfCreases();
  result.Refined = RelevoMeshes::Refine(
    result.Coarse, RelevoMeshes::MakeRecipe(level, normals->GetFittingSurface()));
  return result;
}

// Largest difference between the bounds of two meshes.
double compareBounds(vtkPolyData* a, vtkPolyData* b)
{
  double boundsA[6];
  double boundsB[6];
  a->GetBounds(boundsA);
  b->GetBounds(boundsB);
  double largest = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    largest = std::max(largest, std::abs(boundsA[i] - boundsB[i]));
  }
  return largest;
}

void checkFlatSolids(RelevoCheck& check)
{
  const Mesh solids[] = { makeBlock(), makeRoundedSlab(), makeSolid(VTK_SOLID_ICOSAHEDRON),
    makeSolid(VTK_SOLID_DODECAHEDRON), makeSphere(8) };
  const bool areLinear[] = { true, false, true, true, true };
  for (int i = 0; i < 5; ++i)
  {
    const Fitted fitted = fit(solids[i]);
    CHECK_EQUAL(fitted.IsLinear, areLinear[i]);
    CHECK_NEAR(getVolume(fitted.Refined) / getVolume(solids[i]), 1.0, i == 1 ? 3e-3 : 1e-6);
    CHECK_NEAR(compareBounds(fitted.Refined, solids[i]), 0.0, 0.002 * solids[i]->GetLength());
    CHECK(RelevoWatertight::FindError(fitted.Coarse, fitted.Refined, 3).empty());
  }
  CHECK_EQUAL(fit(solids[0]).NumberOfCreases, 12);
  CHECK_EQUAL(fit(solids[2]).NumberOfCreases, 30);
}

// Only curved parts of a solid become curved.
void checkRoundSolids(RelevoCheck& check)
{
  const double pi = vtkMath::Pi();
  const Mesh sphere = makeSphere(40);
  const Fitted round = fit(sphere, 4);
  CHECK(!round.IsLinear && round.NumberOfCreases == 0);
  const double ball = pi / 6.0; // a ball with a radius of 0.5
  CHECK_LESS(getVolume(sphere), 0.995 * ball);
  CHECK_NEAR(getVolume(round.Refined), ball, 0.001 * ball);

  vtkNew<vtkCylinderSource> source;
  source->SetResolution(24);
  source->SetHeight(2.0);
  const Mesh cylinder = takeShape(source);
  const Fitted tube = fit(cylinder, 4);
  CHECK(!tube.IsLinear && tube.NumberOfCreases == 48);
  double bounds[6];
  tube.Refined->GetBounds(bounds);
  CHECK_NEAR(bounds[3] - bounds[2], 2.0, 1e-6); // along its axis, y
  CHECK_NEAR(getVolume(tube.Refined), 2.0 * pi * 0.25, 0.006 * 2.0 * pi * 0.25);
  CHECK_GREATER(getVolume(tube.Refined), getVolume(cylinder));
  CHECK(RelevoWatertight::FindError(tube.Coarse, tube.Refined, 4).empty());
}

// Moves each point on the line to the centre by up to a share of its distance.
void addNoise(vtkPolyData* mesh, double share)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    vtkMath::MultiplyScalar(x, 1.0 + random->GetNextRangeValue(-share, share));
    mesh->GetPoints()->SetPoint(i, x);
  }
}

// Noise gives no creases, but a finely divided part keeps its creases.
void checkNoise(RelevoCheck& check)
{
  for (double share : { 0.01, 0.02 })
  {
    CHECK_CASE(share);
    const Mesh scan = makeSphere(60);
    addNoise(scan, share);
    vtkNew<vtkCreaseNormals> chosen;
    chosen->SetInputData(scan);
    chosen->KeepCoarseFlatOff();
    chosen->Update();
    CHECK_GREATER(chosen->GetNumberOfCreases(), 200);
    const Fitted smooth = fit(scan, 1);
    CHECK(smooth.IsLinear && smooth.NumberOfCreases == 0);
    CHECK_EQUAL(smooth.Coarse->GetNumberOfPoints(), scan->GetNumberOfPoints());
    CHECK(RelevoWatertight::FindError(smooth.Coarse, smooth.Refined, 1).empty());
  }
  // Stairs have ridges that run into valleys, but their bends are far from the feature angle.
  const Mesh stairs = RelevoMeshes::Make();
  stairs->SetPoints(vtkNew<vtkPoints>());
  stairs->SetPolys(vtkNew<vtkCellArray>());
  const auto addQuad = [&](std::array<std::array<double, 3>, 4> corners)
  {
    stairs->GetPolys()->InsertNextCell(4);
    for (const std::array<double, 3>& corner : corners)
    {
      stairs->GetPolys()->InsertCellPoint(stairs->GetPoints()->InsertNextPoint(corner.data()));
    }
  };
  // The blocks form a chessboard with heights 0 and 1.
  const int size = 6;
  const auto height = [](int i, int j) { return (i + j) % 2 == 0 ? 1.0 : 0.0; };
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const double x = i;
      const double y = j;
      const double z = height(i, j);
      addQuad(
        { { { { x, y, z } }, { { x + 1, y, z } }, { { x + 1, y + 1, z } }, { { x, y + 1, z } } } });
      const double e = height(i + 1, j);
      const double n = height(i, j + 1);
      if (i + 1 < size)
      {
        addQuad({ { { { x + 1, y, z } }, { { x + 1, y, e } }, { { x + 1, y + 1, e } },
          { { x + 1, y + 1, z } } } });
      }
      if (j + 1 < size)
      {
        addQuad({ { { { x, y + 1, z } }, { { x + 1, y + 1, z } }, { { x + 1, y + 1, n } },
          { { x, y + 1, n } } } });
      }
    }
  }
  CHECK(fit(stairs).IsLinear);
  // A finely divided tube with slight noise keeps its rims.
  vtkNew<vtkCylinderSource> source;
  source->SetResolution(60);
  const Mesh tube = takeShape(source);
  addNoise(tube, 0.002);
  CHECK_GREATER_EQUAL(fit(tube).NumberOfCreases, 120);
}

// No side of a cone can follow one normal at the tip, so its sides stay straight.
void checkCone(RelevoCheck& check)
{
  vtkNew<vtkConeSource> source;
  source->SetResolution(36);
  source->SetHeight(2.0);
  const Fitted cone = fit(takeShape(source), 4);
  CHECK(!cone.IsLinear);
  double largest = 0.0;
  for (vtkIdType i = 0; i < cone.Refined->GetNumberOfPoints(); ++i)
  {
    double x[3];
    cone.Refined->GetPoint(i, x);
    // The radius falls from 0.5 at x = -1 to 0 at x = 1.
    largest = std::max(largest, std::hypot(x[1], x[2]) - 0.25 * (1.0 - x[0]));
  }
  CHECK_LESS(largest, 0.003);
  CHECK(RelevoWatertight::FindError(cone.Coarse, cone.Refined, 4).empty());
}

// The mesh's normals are used where its faces can follow them.
void checkGivenNormals(RelevoCheck& check)
{
  vtkNew<vtkSphereSource> sphere; // 8 x 8 faces with normals
  sphere->Update();
  const Fitted round = fit(sphere->GetOutput(), 4);
  CHECK(!round.IsLinear && round.NumberOfCreases == 0);
  CHECK_GREATER(getVolume(round.Refined), 0.95 * vtkMath::Pi() / 6.0);
  vtkDataArray* before = sphere->GetOutput()->GetPointData()->GetNormals();
  vtkDataArray* after = round.Coarse->GetPointData()->GetNormals();
  CHECK_EQUAL(after->GetNumberOfTuples(), before->GetNumberOfTuples());
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    double a[3];
    double b[3];
    before->GetTuple(i, a);
    after->GetTuple(i, b);
    CHECK_LESS(vtkMath::Distance2BetweenPoints(a, b), 1e-10);
  }

  const Mesh block = makeBlock();
  vtkNew<vtkPolyDataNormals> averaged;
  averaged->SetInputData(block);
  averaged->SplittingOff();
  averaged->Update();
  const Fitted flat = fit(averaged->GetOutput());
  CHECK(flat.IsLinear);
  CHECK_NEAR(getVolume(flat.Refined), 8.0, 1e-5);
}

// The result is the same whether faces share points or not.
void checkCoincidentPoints(RelevoCheck& check)
{
  for (const Mesh& mesh : { makeSphere(40), makeBlock(), makeRoundedSlab() })
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(mesh);
    triangles->Update();
    const Fitted shared = fit(triangles->GetOutput());
    const Fitted apart = fit(RelevoMeshes::Explode(triangles->GetOutput()));
    CHECK_EQUAL(shared.IsLinear, apart.IsLinear);
    CHECK_EQUAL(shared.NumberOfCreases, apart.NumberOfCreases);
    const double volume = getVolume(shared.Refined);
    CHECK_NEAR(getVolume(apart.Refined), volume, 1e-6 * volume);
    CHECK(RelevoWatertight::FindError(apart.Coarse, apart.Refined, 3).empty());
  }
}

// Vertices, lines, polygons and strips keep their points and data.
void checkData(RelevoCheck& check)
{
  const Mesh mesh = RelevoMeshes::Mixed();
  vtkNew<vtkDoubleArray> ofPoints;
  ofPoints->SetName("Point");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    ofPoints->InsertNextValue(static_cast<double>(i));
  }
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("Cell");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ofCells->InsertNextValue(static_cast<double>(i));
  }
  mesh->GetPointData()->AddArray(ofPoints);
  mesh->GetCellData()->AddArray(ofCells);
  const Mesh output = fit(mesh, 0).Coarse;
  CHECK_EQUAL(output->GetNumberOfVerts(), mesh->GetNumberOfVerts());
  CHECK_EQUAL(output->GetNumberOfLines(), mesh->GetNumberOfLines());
  CHECK_EQUAL(output->GetNumberOfStrips(), 0);
  CHECK_GREATER(output->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  vtkDataArray* points = output->GetPointData()->GetArray("Point");
  vtkDataArray* cells = output->GetCellData()->GetArray("Cell");
  CHECK_EQUAL(points->GetNumberOfTuples(), output->GetNumberOfPoints());
  CHECK_EQUAL(cells->GetNumberOfTuples(), output->GetNumberOfCells());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    output->GetPoint(i, a);
    mesh->GetPoint(static_cast<vtkIdType>(points->GetComponent(i, 0)), b);
    CHECK(std::equal(a, a + 3, b));
  }
  const vtkIdType firstStrip = mesh->GetNumberOfCells() - mesh->GetNumberOfStrips();
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const double cell = cells->GetComponent(i, 0);
    CHECK(i < firstStrip ? cell == i : cell >= firstStrip);
  }
}

void checkFeatureAngle(RelevoCheck& check)
{
  vtkNew<vtkCreaseNormals> normals;
  normals->SetInputData(makeBlock());
  normals->SetFeatureAngle(100.0);
  normals->KeepCoarseFlatOff();
  normals->Update();
  CHECK_EQUAL(normals->GetNumberOfCreases(), 0);
  CHECK(vtkPNTriangleSurface::SafeDownCast(normals->GetFittingSurface()));
  CHECK_EQUAL(normals->GetOutput()->GetNumberOfPoints(), 8);
  RelevoErrors errors(normals);
  for (double angle : { -1.0, 181.0, vtkMath::Nan() })
  {
    CHECK_CASE(angle);
    normals->SetFeatureAngle(angle);
    CHECK(errors.Said("FeatureAngle must be in [0, 180]"));
    CHECK_EQUAL(normals->GetFeatureAngle(), 100.0);
  }
}

void checkBadInput(RelevoCheck& check)
{
  const Mesh mesh = makeBlock();
  const vtkIdType corners[3] = { 0, 1, 99 };
  mesh->GetPolys()->InsertNextCell(3, corners);
  vtkNew<vtkCreaseNormals> normals;
  RelevoErrors errors(normals);
  normals->SetInputData(mesh);
  normals->Update();
  CHECK(errors.Said("Cell 6 refers to point 99, but there are 8 points."));
  CHECK_EQUAL(normals->GetOutput()->GetNumberOfCells(), 0);
  CHECK(!normals->GetFittingSurface());

  // Empty meshes, faces without area and NaN points give no error and no normal that is not finite.
  normals->SetInputData(RelevoMeshes::Make());
  normals->Update();
  const double nan = vtkMath::Nan();
  normals->SetInputData(RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { nan, 0, 0 } }, { { 0, 1e-200, 0 } } },
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 0, 1, 1 } }, { { 0, 1, 4 } } }));
  normals->Update();
  CHECK(errors.None());
  CHECK_EQUAL(normals->GetOutput()->GetNumberOfCells(), 4);
  vtkDataArray* array = normals->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < 3 * array->GetNumberOfTuples(); ++i)
  {
    CHECK(std::isfinite(array->GetVariantValue(i).ToDouble()));
  }
}
}

int TestCreaseNormals(int, char*[])
{
  RelevoCheck check;
  checkFlatSolids(check);
  checkRoundSolids(check);
  checkNoise(check);
  checkCone(check);
  checkGivenNormals(check);
  checkCoincidentPoints(check);
  checkData(check);
  checkFeatureAngle(check);
  checkBadInput(check);
  return check.GetResult();
}
