// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on picking: VTK's pickers return cells, coordinates, points, blocks, textures,
// vertices and lines of the refined surface, before a frame, after changes and for all methods.
// Other mappers are picked as before.
#include "RelevoDisplacements.h"
#include "RelevoMethods.h"
#include "RelevoPickers.h"
#include "RelevoTestMeshes.h"

#include "vtkAreaPicker.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetMapper.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointPicker.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropPicker.h"
#include "vtkTexture.h"
#include "vtkWorldPointPicker.h"

#include <cmath>
#include <limits>

namespace
{
using namespace RelevoMeshes;

// A textured plane of 1 x 1 at height 0, drawn at height 3.
struct Table
{
  explicit Table(vtkDataObject* mesh, RelevoScene::KindType kind = RelevoScene::Refining)
    : Scene(kind)
  {
    this->Displacement->SetOffset(3.0);
    this->Displacement->SetDirection(0.0, 0.0, 1.0);
    this->Recipe->SetMaximumLevel(2);
    this->Recipe->SetDisplacement(this->Displacement);
    this->Actor = this->Scene.Add(mesh, this->Recipe);
    this->Scene.ResetCameras();
  }
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  RelevoScene Scene;
  vtkActor* Actor;
};

double Distance(const double* a, const double* b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
}

// Cells and parametric coordinates of triangles, quads, larger polygons and strips evaluate to the
// picked point. Vertices and lines are not displaced.
void CheckCells(RelevoCheck& check)
{
  Mesh mesh = Mixed();
  RelevoScene scene(RelevoScene::Refining);
  RelevoPickers::DrawFromFront(scene, mesh, MakeRecipe(2));
  vtkNew<vtkCellPicker> picker;
  vtkNew<vtkGenericCell> cell;
  std::vector<int> hits(static_cast<size_t>(mesh->GetNumberOfCells()), 0);
  for (int y = 3; y < 300; y += 7)
  {
    for (int x = 3; x < 300; x += 7)
    {
      if (!picker->Pick(x + 0.3, y + 0.4, 0.0, scene.Renderer))
      {
        continue;
      }
      const vtkIdType id = picker->GetCellId();
      if (!CHECK(id >= 0 && id < mesh->GetNumberOfCells()))
      {
        continue;
      }
      ++hits[static_cast<size_t>(id)];
      mesh->GetCell(id, cell);
      CHECK_GREATER_EQUAL(cell->PointIds->IsId(picker->GetPointId()), 0);
      if (cell->GetCellType() == VTK_TRIANGLE)
      {
        double place[3];
        double weights[3];
        int subId = picker->GetSubId();
        cell->EvaluateLocation(subId, picker->GetPCoords(), place, weights);
        CHECK_NEAR(Distance(place, picker->GetPickPosition()), 0.0, 1e-6);
      }
      double* nearest = mesh->GetPoint(picker->GetPointId());
      const double distance = Distance(nearest, picker->GetPickPosition());
      CHECK_LESS(distance, 1.5);
    }
  }
  for (size_t id = 3; id < hits.size(); ++id)
  {
    CHECK_GREATER(hits[id], 5);
  }
  // A large tolerance finds a single vertex.
  picker->SetTolerance(0.01);
  double* vertex = mesh->GetPoint(23);
  const auto display = RelevoPickers::ToDisplay(scene.Renderer, vertex[0], vertex[1], vertex[2]);
  CHECK(picker->Pick(display[0] + 1.0, display[1], 0.0, scene.Renderer));
  CHECK_EQUAL(picker->GetCellId(), 0);
  CHECK_EQUAL(picker->GetPointId(), 23);
  CHECK(vtkPolyData::SafeDownCast(picker->GetDataSet()));
  CHECK_EQUAL(picker->GetDataSet()->GetCellType(8), mesh->GetCellType(8));
}

// With a displacement, no point lies at its input position.
void CheckPoints(RelevoCheck& check)
{
  Mesh mesh = Plane(4, 4);
  Table table(mesh);
  table.Scene.Render();
  vtkRenderer* renderer = table.Scene.Renderer;
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); id += 3)
  {
    double p[3];
    mesh->GetPoint(id, p);
    const auto display = RelevoPickers::ToDisplay(renderer, p[0], p[1], 3.0);
    vtkNew<vtkPointPicker> points;
    points->SetTolerance(0.005);
    CHECK(points->Pick(display[0], display[1], 0.0, renderer));
    CHECK_EQUAL(points->GetPointId(), id);
    CHECK_NEAR(points->GetPickPosition()[2], 3.0, 1e-6);
    CHECK_EQUAL(points->GetDataSet(), mesh);
    points->UseCellsOn();
    CHECK(points->Pick(display[0], display[1], 0.0, renderer));
    CHECK_EQUAL(points->GetPointId(), id);
  }
  vtkNew<vtkCellPicker> cells;
  CHECK(cells->Pick(150, 150, 0.0, renderer));
  CHECK_NEAR(cells->GetPickPosition()[2], 3.0, 1e-6);
  CHECK_NEAR(cells->GetPickNormal()[2], 1.0, 1e-6);
  // Other pickers use bounds, or the pixels drawn by the graphics card.
  vtkNew<vtkPicker> bounds;
  CHECK(bounds->Pick(150, 150, 0.0, renderer));
  CHECK_NEAR(bounds->GetPickPosition()[2], 3.0, 1e-6);
  CHECK_EQUAL(bounds->GetDataSet(), mesh);
  vtkNew<vtkPropPicker> props;
  CHECK(props->Pick(150, 150, 0.0, renderer));
  CHECK_NEAR(props->GetPickPosition()[2], 3.0, 1e-2);
  vtkNew<vtkWorldPointPicker> world;
  world->Pick(150, 150, 0.0, renderer);
  CHECK_NEAR(world->GetPickPosition()[2], 3.0, 1e-2);
  vtkNew<vtkAreaPicker> area;
  CHECK_EQUAL(area->AreaPick(140, 140, 160, 160, renderer), 1);
  // The mapper's input is unchanged.
  double ignored[6];
  table.Actor->GetMapper()->GetBounds(ignored);
  CHECK_EQUAL(
    vtkAdaptiveRefinementMapper::SafeDownCast(table.Actor->GetMapper())->GetInput(), mesh);
  CHECK_EQUAL(table.Actor->GetMapper()->GetInput(), mesh);
  CHECK_EQUAL(table.Actor->GetMapper()->GetInputDataObject(0, 0), mesh);
}

// Changes take effect in the next pick, with or without a frame in between.
void CheckChanges(RelevoCheck& check)
{
  Mesh mesh = Plane(4, 4);
  Table table(mesh);
  vtkNew<vtkCellPicker> picker;
  const auto heightOf = [&](double height)
  {
    table.Scene.ResetCameras();
    CHECK(picker->Pick(150, 150, 0.0, table.Scene.Renderer));
    CHECK_NEAR(picker->GetPickPosition()[2], height, 1e-6);
  };
  heightOf(3.0); // without a frame
  table.Displacement->SetOffset(-2.0);
  heightOf(-2.0);
  table.Scene.Render();
  heightOf(-2.0);
  table.Displacement->SetOffset(1.0);
  heightOf(1.0);
  table.Scene.Render();
  // Another recipe with levels for a view that has not been drawn.
  {
    vtkNew<vtkDistanceDepthTagMetric> metric;
    auto recipe = MakeRecipe(3, nullptr, table.Displacement);
    recipe->SetMetric(metric);
    table.Scene.GetMapper(0)->SetRefinement(recipe);
    heightOf(1.0);
    table.Scene.Render();
    heightOf(1.0);
    recipe->SetMaximumLevel(1);
    heightOf(1.0);
  }
  mesh->GetPoints()->SetPoint(12, 0.0, 0.0, 0.5);
  mesh->GetPoints()->Modified();
  mesh->Modified();
  table.Scene.ResetCameras();
  CHECK(picker->Pick(150, 150, 0.0, table.Scene.Renderer));
  CHECK_GREATER(picker->GetPickPosition()[2], 1.1);
  table.Scene.GetMapper(0)->SetInputData(Plane(2, 2));
  heightOf(1.0);
  // Degenerate cells and NaN points do not disturb picks.
  Mesh bad = Plane(4, 4);
  bad->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  for (int n = 0; n < 4; ++n)
  {
    const vtkIdType ids[3] = { 1, 1, 1 };
    bad->GetPolys()->InsertNextCell(n, ids);
  }
  RelevoErrors warnings(table.Scene.GetMapper(0));
  table.Scene.GetMapper(0)->SetInputData(bad);
  CHECK(picker->Pick(150, 150, 0.0, table.Scene.Renderer));
  CHECK_NEAR(picker->GetPickPosition()[2], 1.0, 1e-6);
  vtkNew<vtkPointPicker> points;
  points->SetTolerance(0.1);
  CHECK(points->Pick(150, 150, 0.0, table.Scene.Renderer));
  CHECK_GREATER(points->GetPointId(), 0);
  table.Scene.GetMapper(0)->SetInputData(vtkNew<vtkPolyData>());
  CHECK(!picker->Pick(150, 150, 0.0, table.Scene.Renderer));
}

void CheckBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  Mesh meshes[2] = { Plane(4, 4), Plane(4, 4) };
  const double offset[3] = { 1.2, 0.0, 0.0 };
  meshes[1] = Moved(meshes[1], 1.0, offset, VTK_FLOAT);
  blocks->SetBlock(0, meshes[0]);
  blocks->SetBlock(2, meshes[1]);
  Table table(blocks);
  table.Scene.MoveCamera = [](vtkCamera*) {};
  table.Scene.ResetCameras();
  table.Scene.Render();
  for (int block = 0; block < 2; ++block)
  {
    const auto display =
      RelevoPickers::ToDisplay(table.Scene.Renderer, 1.2 * block + 0.125, 0.125, 3.0);
    vtkNew<vtkCellPicker> cells;
    CHECK(cells->Pick(display[0], display[1], 0.0, table.Scene.Renderer));
    CHECK_NEAR(cells->GetPickPosition()[2], 3.0, 1e-6);
    CHECK_EQUAL(cells->GetFlatBlockIndex(), 1 + 2 * block);
    double center[3];
    meshes[block]->GetCell(cells->GetCellId())->GetParametricCenter(center);
    CHECK(cells->GetDataSet()->GetCellData() && cells->GetCellId() == 10);
    vtkNew<vtkPointPicker> points;
    points->SetTolerance(0.1);
    CHECK(points->Pick(display[0], display[1], 0.0, table.Scene.Renderer));
    CHECK_NEAR(points->GetPickPosition()[2], 3.0, 1e-6);
    CHECK_EQUAL(points->GetFlatBlockIndex(), 1 + 2 * block);
    CHECK_EQUAL(points->GetCompositeDataSet(), blocks);
    vtkNew<vtkPicker> bounds;
    CHECK(bounds->Pick(display[0], display[1], 0.0, table.Scene.Renderer));
    CHECK_EQUAL(bounds->GetFlatBlockIndex(), 1 + 2 * block);
    CHECK_NEAR(bounds->GetPickPosition()[2], 3.0, 1e-6);
  }
}

// The visible texel, on the refined surface and on its twin.
void CheckTextures(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  Mesh mesh = Torus();
  vtkNew<RelevoHeights> waves;
  waves->FillWaves();
  auto displacement = MakeDisplacement(waves, 0.1);
  const auto recipe = MakeRecipe(3, nullptr, displacement);
  RelevoScene refining(RelevoScene::Refining);
  RelevoScene twin(RelevoScene::Twin);
  for (RelevoScene* scene : { &refining, &twin })
  {
    scene->Add(mesh, recipe)->SetTexture(texture);
    scene->ResetCameras();
    scene->Render();
  }
  twin.CopyCameras(refining);
  vtkNew<vtkCellPicker> picker;
  vtkNew<vtkCellPicker> oracle;
  int hits = 0;
  for (int i = 0; i < 100; ++i)
  {
    for (vtkCellPicker* one : { picker.Get(), oracle.Get() })
    {
      one->PickTextureDataOn();
      hits += one->Pick(
        37 * i % 300 + 0.3, 83 * i % 300 + 0.4, 0.0, (one == picker ? refining : twin).Renderer);
    }
    CHECK_EQUAL(picker->GetTexture(), oracle->GetTexture());
    CHECK_EQUAL(picker->GetDataSet(), oracle->GetDataSet());
    for (int c = 0; c < 2; ++c)
    {
      CHECK_NEAR(picker->GetCellIJK()[c] + picker->GetPCoords()[c],
        oracle->GetCellIJK()[c] + oracle->GetPCoords()[c], 1e-3);
    }
  }
  CHECK_GREATER(hits, 30);
}

// All methods draw the same points on edges, so picks agree if levels do not morph.
void CheckMethods(RelevoCheck& check)
{
  for (int method : RelevoMethods::GetMethods())
  {
    RelevoScene refining(RelevoScene::Refining);
    RelevoScene twin(RelevoScene::Twin);
    vtkNew<vtkPNTriangleSurface> surface;
    const auto recipe = MakeRecipe(4, surface);
    // The uniform method draws the highest level everywhere.
    Mesh mesh =
      method == RelevoMethods::Mapper::METHOD_UNIFORM ? Sphere(9, 7) : Tagged(Sphere(9, 7), 4);
    refining.Add(mesh, recipe);
    twin.Add(mesh, recipe);
    refining.GetMapper(0)->SetMethod(method);
    refining.ResetCameras();
    twin.UpdateFilters();
    twin.CopyCameras(refining);
    refining.Render();
    twin.Render();
    CHECK_EQUAL(refining.GetMapper(0)->GetMethodInUse(), method);
    CHECK_GREATER(RelevoPickers::Compare(refining, twin, 40, RelevoMethods::GetName(method)), 5);
  }
}

// VTK handles pickable clipping planes and other mappers.
void CheckOthers(RelevoCheck& check)
{
  RelevoScene refining(RelevoScene::Refining);
  RelevoScene twin(RelevoScene::Twin);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.2, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.1, 0.0);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  for (RelevoScene* scene : { &refining, &twin })
  {
    vtkActor* actor = scene->Add(Sphere(20, 16), MakeRecipe(0));
    actor->GetMapper()->SetClippingPlanes(planes);
    vtkNew<vtkPolyDataMapper> other;
    other->SetInputData(Cube());
    vtkNew<vtkActor> box;
    box->SetMapper(other);
    box->SetPosition(1.2, 0.0, 0.0);
    scene->Renderer->AddActor(box);
    scene->MoveCamera = [](vtkCamera* camera) { camera->Azimuth(50.0); };
    scene->ResetCameras();
    scene->Render();
  }
  twin.CopyCameras(refining);
  const auto alike = [](vtkCellPicker* a, vtkCellPicker* b)
  { return a->GetClippingPlaneId() == b->GetClippingPlaneId(); };
  CHECK_GREATER(RelevoPickers::Compare(
                  refining, twin, 150, "clipping planes picked", {},
                  [](vtkCellPicker* picker) { picker->PickClippingPlanesOn(); }, alike),
    20);
}
}

int TestAdaptiveRefinementMapperPickers(int, char*[])
{
  RelevoCheck check;
  CheckCells(check);
  CheckPoints(check);
  CheckChanges(check);
  CheckBlocks(check);
  CheckTextures(check);
  CheckMethods(check);
  CheckOthers(check);
  return check.GetResult();
}
