// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves vtkVolumeProbe against closed forms of the opacity, and against VTK's cells.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkVolumeProbe.h"

#include "vtkActor.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkContourValues.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <cmath>
#include <vector>

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;

RelevoPoint GetPosition(vtkVolumeProbe* probe)
{
  RelevoPoint at;
  probe->GetPosition(at.data());
  return at;
}

double GetDistance(const RelevoPoint& a, const RelevoPoint& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

vtkSmartPointer<vtkVolumeProbe> MakeProbe(RelevoVolumeScene& scene, double threshold = 0.5)
{
  auto probe = vtkSmartPointer<vtkVolumeProbe>::New();
  probe->SetRenderer(scene.GetRenderer());
  probe->SetOpacityThreshold(threshold);
  return probe;
}

// The field is x, and extinction is 2 x: along a ray, the optical depth is a quadratic function.
void TestDepth(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, [](const RelevoPoint& at) { return at[0]; }),
    MakeVolumeProperty(0.0, 1.0, 0.5), Width, Height);
  int hits = 0;
  int misses = 0;
  for (const double threshold : { 0.1, 0.5, 0.8 })
  {
    CHECK_CASE(threshold);
    const auto probe = MakeProbe(scene, threshold);
    for (int i = 0; i < Width * Height; i += 37)
    {
      CHECK_CASE(i);
      const int column = i % Width;
      const int row = i / Width;
      const RelevoRay ray(scene.GetCamera(), column, row, Width, Height);
      double begin;
      double end;
      const bool isInside = ray.CutBox(0.0, 1.0, begin, end);
      const double start = 2.0 * ray.At(begin)[0];
      const double slope = 2.0 * ray.Direction[0];
      const double length = end - begin;
      const double depth = -std::log(1.0 - threshold);
      const bool isHit = isInside && start * length + 0.5 * slope * length * length >= depth;
      CHECK_EQUAL(probe->Probe(column, row), isHit);
      ++(isHit ? hits : misses);
      if (isHit)
      {
        const double root = std::sqrt(start * start + 2.0 * slope * depth);
        const double way = 2.0 * depth / (start + root);
        CHECK_NEAR(GetDistance(GetPosition(probe), ray.At(begin + way)), 0.0, 1e-4);
        CHECK_NEAR(probe->GetValue(), GetPosition(probe)[0], 1e-12);
      }
      else
      {
        CHECK_EQUAL(probe->GetCellId(), -1);
        CHECK(std::isnan(probe->GetValue()));
        CHECK(!probe->GetVolume() && !probe->GetDataSet());
      }
    }
  }
  CHECK_GREATER(hits, 30);
  CHECK_GREATER(misses, 50);
}

// The result agrees with VTK's functions of the cell.
void CheckCell(RelevoCheck& check, vtkVolumeProbe* probe, vtkDataSet* mesh)
{
  CHECK_EQUAL(probe->GetDataSet(), mesh);
  vtkNew<vtkGenericCell> cell;
  mesh->GetCell(probe->GetCellId(), cell);
  const RelevoPoint position = GetPosition(probe);
  RelevoPoint parameters;
  probe->GetParametricCoordinates(parameters.data());
  std::vector<double> weights(static_cast<size_t>(cell->GetNumberOfPoints()));
  // An independent evaluation by VTK, whose Newton iteration stops early.
  int subId;
  RelevoPoint theirs;
  double distance2;
  double closest[3];
  CHECK_EQUAL(cell->EvaluatePosition(
                position.data(), closest, subId, theirs.data(), distance2, weights.data()) >= 0,
    true);
  CHECK_NEAR(GetDistance(parameters, theirs), 0.0, cell->IsLinear() ? 1e-4 : 0.1);
  // The coordinates are those of the position, and the value is interpolated with their weights.
  RelevoPoint there;
  cell->EvaluateLocation(subId, parameters.data(), there.data(), weights.data());
  CHECK_NEAR(GetDistance(there, position), 0.0, 1e-9);
  double value = 0.0;
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (size_t i = 0; i < weights.size(); ++i)
  {
    value += weights[i] * values->GetComponent(cell->GetPointId(static_cast<int>(i)), 0);
  }
  CHECK_NEAR(probe->GetValue(), value, 1e-9);
  for (const double parameter : parameters)
  {
    CHECK(parameter > -1e-6 && parameter < 1.0 + 1e-6);
  }
}

void CheckCells(RelevoCheck& check, vtkUnstructuredGrid* mesh, double unitDistance)
{
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.9, 0.9, unitDistance), Width, Height);
  const auto probe = MakeProbe(scene);
  int hits = 0;
  for (int i = 0; i < Width * Height; i += 23)
  {
    CHECK_CASE(i);
    if (probe->Probe(i % Width, i / Width))
    {
      ++hits;
      CheckCell(check, probe, mesh);
    }
  }
  CHECK_GREATER(hits, 5);
}

void TestCells(RelevoCheck& check)
{
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    CHECK_CASE(type);
    CheckCells(check, MakeBlocksOfCells(type, GetTrilinear, 0.1), 1.0);
  }
  for (const int type : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON,
         VTK_TRIQUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_LAGRANGE_HEXAHEDRON,
         VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE })
  {
    CHECK_CASE(type);
    const bool isQuadratic = type < VTK_LAGRANGE_CURVE;
    CheckCells(check, RelevoCurvedCells(isQuadratic ? 2 : 3).Make(type, 1), 0.3);
  }
}

// Cells that split have the values of their pieces, and cell values are those of the cell.
void TestCellValues(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkDoubleArray> values;
  values->SetName("ids");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i));
  }
  mesh->GetCellData()->AddArray(values);
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(1.0, 1.0, 0.2), Width, Height);
  scene.GetMapper()->SetScalarModeToUseCellFieldData();
  scene.GetMapper()->SelectScalarArray("ids");
  const auto probe = MakeProbe(scene);
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_EQUAL(probe->GetValue(), static_cast<double>(probe->GetCellId()));
  // New values are read.
  values->FillValue(7.0);
  values->Modified();
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_EQUAL(probe->GetValue(), 7.0);
}

void TestSurfaces(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(3, [](const RelevoPoint& at) { return at[2]; });
  const auto property = MakeVolumeProperty(0.0, 1.0, 1e6);
  property->GetIsoSurfaceValues()->SetValue(0, 0.625);
  RelevoVolumeScene scene(mesh, property, Width, Height);
  const auto probe = MakeProbe(scene);
  CHECK(!probe->Probe(Width / 2, Height / 2));
  scene.GetMapper()->IsoSurfacesOn();
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_NEAR(GetPosition(probe)[2], 0.625, 1e-12);
  CHECK_NEAR(probe->GetValue(), 0.625, 1e-12);
  // Its opacity is 0.625.
  probe->SetOpacityThreshold(0.63);
  CHECK(!probe->Probe(Width / 2, Height / 2));
  probe->SetOpacityThreshold(0.62);
  scene.GetMapper()->SetBlendModeToIsoSurface();
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_NEAR(GetPosition(probe)[2], 0.625, 1e-12);
}

void TestBlendModes(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(3, [](const RelevoPoint& at) { return at[2]; });
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.0, 1.0, 1.0), Width, Height);
  const auto probe = MakeProbe(scene);
  RelevoErrors errors(probe);
  scene.GetMapper()->SetBlendModeToMaximumIntensity();
  const RelevoRay ray(scene.GetCamera(), Width / 2, Height / 2, Width, Height);
  double begin;
  double end;
  ray.CutBox(0.0, 1.0, begin, end);
  const double highest = std::max(ray.At(begin)[2], ray.At(end)[2]);
  CHECK_GREATER(highest, 0.5);
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_NEAR(probe->GetValue(), highest, 1e-6);
  scene.GetMapper()->SetBlendModeToMinimumIntensity(); // whose opacity is below the threshold
  CHECK(!probe->Probe(Width / 2, Height / 2));
  // The sum of extinction, which composite blending would turn into an opacity of 0.39.
  scene.GetMapper()->SetBlendModeToAdditive();
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK(errors.None());
  scene.GetMapper()->SetBlendModeToAverageIntensity();
  CHECK(!probe->Probe(Width / 2, Height / 2));
  CHECK(errors.Said("Average blending has no position along the ray"));
}

// Planes move the position, and opaque actors hide it.
void TestInFront(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, [](const RelevoPoint&) { return 1.0; }),
    MakeVolumeProperty(1.0, 1.0, 0.2), Width, Height);
  const auto probe = MakeProbe(scene);
  CHECK(probe->Probe(Width / 2, Height / 2));
  const RelevoPoint before = GetPosition(probe);
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0.45, 0.55, 0.45, 0.55, 0.45, 0.55);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.GetRenderer()->AddActor(actor);
  CHECK(probe->Probe(Width / 2, Height / 2)); // behind
  CHECK_NEAR(GetDistance(before, GetPosition(probe)), 0.0, 1e-12);
  // 90 % of the way to the camera.
  const double* eye = scene.GetCamera()->GetPosition();
  actor->SetPosition(0.6 * (eye[0] - 0.5), 0.6 * (eye[1] - 0.5), 0.6 * (eye[2] - 0.5));
  scene.GetRenderer()->ResetCameraClippingRange();
  CHECK(!probe->Probe(Width / 2, Height / 2));
  actor->GetProperty()->SetOpacity(0.5);
  CHECK(probe->Probe(Width / 2, Height / 2));
  actor->GetProperty()->SetOpacity(1.0);
  actor->VisibilityOff();
  // The plane through the middle that faces the camera.
  vtkNew<vtkPlane> plane;
  double forward[3];
  scene.GetCamera()->GetDirectionOfProjection(forward);
  plane->SetNormal(forward);
  plane->SetOrigin(0.5, 0.5, 0.5);
  scene.GetMapper()->AddClippingPlane(plane);
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_NEAR(plane->EvaluateFunction(GetPosition(probe).data()), 0.2 * std::log(2.0), 1e-3);
  scene.GetVolume()->PickableOff();
  CHECK(!probe->Probe(Width / 2, Height / 2));
}

// A matrix that stretches and turns equals transformed points.
void TestMatrix(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetTrilinear, 0.1);
  const auto property = MakeVolumeProperty(0.3, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> steepness;
  steepness->AddPoint(0.0, 0.2);
  steepness->AddPoint(1.0, 1.0);
  property->SetGradientOpacity(steepness);
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 2.0, 0.5);
  const auto moved = vtkSmartPointer<vtkUnstructuredGrid>::New();
  moved->DeepCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  transform->TransformPoints(mesh->GetPoints(), points);
  moved->SetPoints(points);
  RelevoVolumeScene expected(moved, property, Width, Height);
  RelevoVolumeScene scene(mesh, property, Width, Height);
  scene.GetVolume()->SetUserTransform(transform);
  scene.GetRenderer()->SetActiveCamera(expected.GetCamera());
  const auto theirs = MakeProbe(expected);
  const auto probe = MakeProbe(scene);
  int hits = 0;
  for (int i = 0; i < Width * Height; i += 23)
  {
    CHECK_CASE(i);
    const bool isHit = theirs->Probe(i % Width, i / Width);
    CHECK_EQUAL(probe->Probe(i % Width, i / Width), isHit);
    if (isHit)
    {
      ++hits;
      CHECK_NEAR(GetDistance(GetPosition(probe), GetPosition(theirs)), 0.0, 1e-3);
      CHECK_EQUAL(probe->GetCellId(), theirs->GetCellId());
      CHECK_NEAR(probe->GetValue(), theirs->GetValue(), 1e-3);
    }
  }
  CHECK_GREATER(hits, 5);
}

void TestBlocks(RelevoCheck& check)
{
  const auto near = MakeTetrahedra(2, GetLinearField, 1.0);
  const auto far = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(0, far);
  blocks->SetBlock(2, near);
  RelevoVolumeScene scene(blocks, MakeVolumeProperty(1.0, 1.0, 0.2), Width, Height);
  scene.GetCamera()->SetPosition(5.0, 5.0, 5.0);
  scene.GetCamera()->SetFocalPoint(1.0, 1.0, 1.0);
  scene.GetRenderer()->ResetCameraClippingRange();
  const auto probe = MakeProbe(scene);
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_EQUAL(probe->GetFlatBlockIndex(), 3);
  CheckCell(check, probe, near);
  CHECK_EQUAL(probe->GetVolume(), scene.GetVolume());
  scene.GetCamera()->SetPosition(-3.0, -3.0, -3.0);
  scene.GetRenderer()->ResetCameraClippingRange();
  CHECK(probe->Probe(Width / 2, Height / 2));
  CHECK_EQUAL(probe->GetFlatBlockIndex(), 1);
  CheckCell(check, probe, far);
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkVolumeProbe> alone;
  RelevoErrors aloneErrors(alone);
  CHECK(!alone->Probe(0, 0));
  CHECK(aloneErrors.Said("There is no renderer: call SetRenderer()."));
  alone->SetOpacityThreshold(0.0);
  CHECK(aloneErrors.Said("OpacityThreshold"));
  CHECK_EQUAL(alone->GetOpacityThreshold(), 0.5);

  RelevoVolumeScene scene(MakeTetrahedra(2, GetLinearField), MakeLinearProperty(), Width, Height);
  const auto probe = MakeProbe(scene);
  RelevoErrors errors(probe);
  CHECK(!probe->Probe(-1, 0) && !probe->Probe(Width, 0) && !probe->Probe(0, Height));
  CHECK(errors.None());
  scene.GetMapper()->SetScalarModeToUsePointFieldData();
  scene.GetMapper()->SelectScalarArray("missing");
  CHECK(!probe->Probe(Width / 2, Height / 2));
  CHECK(errors.Said("has no array \"missing\""));
  CHECK(!probe->Probe(Width / 2, Height / 2));
  CHECK(errors.None()); // reported once
  CHECK(std::isnan(probe->GetValue(1)));
  CHECK(errors.Said("There is no component 1"));
}
}

int TestVolumeProbe(int, char*[])
{
  RelevoCheck check;
  TestDepth(check);
  TestCells(check);
  TestCellValues(check);
  TestSurfaces(check);
  TestBlendModes(check);
  TestInFront(check);
  TestMatrix(check);
  TestBlocks(check);
  TestErrors(check);
  return check.GetResult();
}
