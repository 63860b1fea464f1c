// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMeshVisibilitySort promises that cells along a ray come in visibility order. The test casts
// random rays through convex meshes, all kinds of cells and parts that touch, for several cameras
// and model transforms.
#include "RelevoCheck.h"
#include "RelevoRefinedCells.h"
#include "RelevoVisibility.h"
#include "vtkMeshVisibilitySort.h"

#include "vtkAppendFilter.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <algorithm>

namespace
{
constexpr int NumberOfRays = 60;
using Mesh = vtkSmartPointer<vtkUnstructuredGrid>;

// Cameras outside and inside the mesh, and parallel projections.
void CheckMesh(RelevoCheck& check, vtkDataSet* mesh, RelevoDice& dice, int numberOfViews = 3)
{
  const RelevoConvexCells cells(mesh);
  double middle[3];
  mesh->GetCenter(middle);
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  vtkIdType numberOfPairs = 0;
  for (int view = 0; view < 3 * numberOfViews; ++view)
  {
    const double away = mesh->GetLength() * (view % 3 == 0 ? 0.2 : 1.5);
    const RelevoPoint side = { { dice.Signed(), dice.Signed(), dice.Signed() } };
    const auto camera = MakeCamera(
      { { middle[0] + away * side[0], middle[1] + away * side[1], middle[2] + away * side[2] } },
      { { middle[0], middle[1], middle[2] } });
    camera->SetParallelProjection(view % 3 == 2);
    sort->SetCamera(camera);
    const std::vector<vtkIdType> order = Traverse(sort);
    CHECK(IsEachOnce(mesh, order));
    CHECK_EQUAL(sort->GetNumberOfCycles(), 0);

    std::array<double, 4> eye = { { 0.0, 0.0, 0.0, 1.0 } };
    camera->GetPosition(eye.data());
    if (camera->GetParallelProjection())
    {
      camera->GetDirectionOfProjection(eye.data());
      std::transform(eye.begin(), eye.end(), eye.begin(), [](double x) { return -x; });
      eye[3] = 0.0;
    }
    const RelevoPairs pairs = cells.Compare(order, eye, NumberOfRays, dice);
    numberOfPairs += pairs.All;
    CHECK_EQUAL(pairs.Wrong, 0);
  }
  CHECK_GREATER(2 * numberOfPairs, numberOfViews * NumberOfRays);
}

// A box of tetrahedra with uneven sizes.
Mesh MakeUneven(int n, RelevoDice& dice)
{
  Mesh mesh = MakeTetrahedra(n, GetLinearField);
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    for (double& coordinate : x)
    {
      const bool isInside = coordinate > 0.0 && coordinate < 1.0;
      coordinate += isInside ? 0.2 * dice.Signed() / n : 0.0;
    }
    points->SetPoint(i, x[0], 2.0 * x[1], 0.3 * x[2]);
  }
  return mesh;
}

// All cells have separate points, and every second cell is inside out.
Mesh TakeApart(vtkUnstructuredGrid* mesh, RelevoDice& dice)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto apart = Mesh::New();
  apart->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    std::vector<vtkIdType> own;
    for (vtkIdType id : *ids)
    {
      own.push_back(points->InsertNextPoint(mesh->GetPoint(id)));
    }
    if (mesh->GetCellType(i) == VTK_TETRA && dice.Once(2))
    {
      std::swap(own[0], own[1]);
    }
    apart->InsertNextCell(mesh->GetCellType(i), static_cast<vtkIdType>(own.size()), own.data());
  }
  return apart;
}

void TestUneven(RelevoCheck& check, RelevoDice& dice)
{
  for (int n : { 2, 3, 6 })
  {
    CHECK_CASE(n);
    const Mesh mesh = MakeUneven(n, dice);
    CheckMesh(check, mesh, dice);
    CheckMesh(check, TakeApart(mesh, dice), dice);
  }
}

// Cells next to smaller ones.
void TestHanging(RelevoCheck& check, RelevoDice& dice)
{
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA })
  {
    CHECK_CASE(type);
    RelevoRefinedCells cells;
    cells.Levels = 2;
    const Mesh mesh = cells.Make(type);
    CheckMesh(check, mesh, dice);
    CheckMesh(check, TakeApart(mesh, dice), dice);
  }
}

void TestCellTypes(RelevoCheck& check, RelevoDice& dice)
{
  const int types[] = { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_PENTAGONAL_PRISM,
    VTK_HEXAGONAL_PRISM, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_WEDGE,
    VTK_QUADRATIC_PYRAMID };
  for (int type : types)
  {
    vtkNew<vtkCellTypeSource> source;
    source->SetCellType(type);
    source->SetBlocksDimensions(3, 2, 4);
    source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    source->Update();
    CHECK_GREATER(source->GetOutput()->GetNumberOfCells(), 20);
    CheckMesh(check, source->GetOutput(), dice, 2);
    CheckMesh(check, TakeApart(source->GetOutput(), dice), dice, 2);
  }
  vtkNew<vtkImageData> image; // voxels
  image->SetDimensions(5, 4, 6);
  image->SetSpacing(1.0, 2.0, 0.5);
  CheckMesh(check, image, dice);
}

Mesh MakePolyhedra()
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_HEXAGONAL_PRISM);
  source->SetBlocksDimensions(3, 3, 3);
  source->Update();
  vtkUnstructuredGrid* prisms = source->GetOutput();
  auto mesh = Mesh::New();
  mesh->SetPoints(prisms->GetPoints());
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < prisms->GetNumberOfCells(); ++i)
  {
    prisms->GetCell(i, cell);
    std::vector<vtkIdType> faces;
    for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
    {
      vtkIdList* ids = cell->GetFace(face)->GetPointIds();
      faces.push_back(ids->GetNumberOfIds());
      faces.insert(faces.end(), ids->begin(), ids->end());
    }
    mesh->InsertNextCell(VTK_POLYHEDRON, cell->GetNumberOfPoints(),
      cell->GetPointIds()->GetPointer(0), cell->GetNumberOfFaces(), faces.data());
  }
  return mesh;
}

Mesh Append(vtkDataSet* first, vtkDataSet* second)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(first);
  append->AddInputData(second);
  append->Update();
  Mesh mesh = append->GetOutput();
  return mesh;
}

Mesh Move(vtkDataSet* mesh, const RelevoPoint& scale, const RelevoPoint& step)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(step.data());
  transform->Scale(scale.data());
  vtkNew<vtkTransformFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(mesh);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  Mesh moved = vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
  return moved;
}

// Slabs that touch, so flat that distances of faces do not order them. Their faces match, but their
// diagonals differ or exist on one side only.
void TestSeams(RelevoCheck& check, RelevoDice& dice)
{
  const auto cube = MakeTetrahedra(1, GetLinearField);
  const Mesh slab = Move(cube, { { 1.0, 1.0, 0.05 } }, { { 0.0, 0.0, 0.0 } });
  CheckMesh(
    check, Append(slab, Move(slab, { { 1.0, -1.0, 1.0 } }, { { 0.0, 1.0, 0.05 } })), dice, 20);

  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_HEXAHEDRON);
  source->Update();
  CheckMesh(check,
    Append(slab, Move(source->GetOutput(), { { 1.0, 1.0, 0.05 } }, { { 0.0, 0.0, 0.05 } })), dice,
    20);
}

// Rays are in the mesh's coordinates.
void TestTransform(RelevoCheck& check, RelevoDice& dice)
{
  const Mesh mesh = MakeUneven(4, dice);
  const RelevoConvexCells cells(mesh);
  vtkNew<vtkTransform> transform;
  transform->Translate(1e4, -30.0, 7.0);
  transform->RotateWXYZ(70.0, 1.0, 2.0, -1.0);
  transform->Scale(-3.0, 0.5, 20.0);
  const double* middle = transform->TransformDoublePoint(mesh->GetCenter());
  const auto camera = MakeCamera({ { middle[0] + 9.0, middle[1] - 30.0, middle[2] + 20.0 } },
    { { middle[0], middle[1], middle[2] } });
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  sort->SetCamera(camera);
  sort->SetModelTransform(transform->GetMatrix());
  for (bool isParallel : { false, true })
  {
    CHECK_CASE(isParallel);
    camera->SetParallelProjection(isParallel);
    std::array<double, 4> eye = { { 0.0, 0.0, 0.0, 1.0 } };
    if (isParallel)
    {
      const double* direction =
        transform->GetLinearInverse()->TransformDoubleVector(camera->GetDirectionOfProjection());
      eye = { { -direction[0], -direction[1], -direction[2], 0.0 } };
    }
    else
    {
      transform->GetLinearInverse()->TransformPoint(camera->GetPosition(), eye.data());
    }
    const RelevoPairs pairs = cells.Compare(Traverse(sort), eye, 5 * NumberOfRays, dice);
    CHECK_GREATER(pairs.All, 5 * NumberOfRays);
    CHECK_EQUAL(pairs.Wrong, 0);
  }

  // An oblique view equals the view from another side.
  sort->SetModelTransform(vtkNew<vtkMatrix4x4>());
  camera->SetFocalPoint(0.5, 1.0, 0.1);
  camera->SetPosition(0.5, 1.0, 9.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewShear(0.8, -0.3, 1.0);
  const std::vector<vtkIdType> order = Traverse(sort);
  const RelevoPairs sheared = cells.Compare(order, { { 0.8, -0.3, 1.0, 0.0 } }, 500, dice);
  const RelevoPairs mirrored = cells.Compare(order, { { -0.8, 0.3, 1.0, 0.0 } }, 500, dice);
  CHECK_GREATER(sheared.All, 500);
  CHECK_GREATER(mirrored.All, 500);
  CHECK_EQUAL(std::min(sheared.Wrong, mirrored.Wrong), 0);
  CHECK_GREATER(std::max(sheared.Wrong, mirrored.Wrong), 0);
}
}

int TestMeshVisibilitySort(int, char*[])
{
  RelevoCheck check;
  RelevoDice dice(1);
  TestUneven(check, dice);
  TestHanging(check, dice);
  TestCellTypes(check, dice);
  CheckMesh(check, MakePolyhedra(), dice);
  TestSeams(check, dice);
  TestTransform(check, dice);
  return check.GetResult();
}
