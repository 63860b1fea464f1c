// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's pickers find the terrain as it is drawn. Their positions have the heights of the raster
// within an error in pixels.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkAreaPicker.h"
#include "vtkCellPicker.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointPicker.h"
#include "vtkPropPicker.h"
#include "vtkRenderedAreaPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"
#include "vtkWorldPointPicker.h"
#if __has_include(<vtkHardwarePicker.h>)
#include "vtkHardwarePicker.h"
#endif

#include <cmath>

namespace
{
constexpr int Size = 401;
constexpr double Spacing = 25.0;
constexpr double Half = 0.5 * Spacing * (Size - 1);
constexpr int Width = 320;
constexpr int Height = 240;

std::string WriteHills(const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, Spacing);
  raster.SetValues(
    [](int, int column, int row)
    {
      return 900.0 + 500.0 * std::sin(column / 60.0) * std::cos(row / 80.0) +
        120.0 * std::sin(column / 19.0 + row / 31.0) + 10.0 * std::cos(column / 3.0 - row / 4.0);
    });
  const std::string file = folders.File("TerrainMapperPicks.tif");
  return raster.Write(file) ? file : "";
}

class PickScene : public RelevoPyramidScene
{
public:
  explicit PickScene(const std::string& file)
    : RelevoPyramidScene(file, Width, Height)
  {
    this->Look(0.0);
  }

  void Look(double x)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x - 800.0, -1.3 * Half, 4000.0);
    camera->SetFocalPoint(x, 0.0, 1500.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
  }

  // The pixels that a length covers at a point, in any direction.
  double GetPixels(double length, const double point[3])
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double factor =
      Height / (2.0 * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0));
    return length * factor /
      std::sqrt(vtkMath::Distance2BetweenPoints(camera->GetPosition(), point));
  }
};

// The distance in pixels of a picked point from the height of the raster at its longitude and
// latitude.
double MeasureHeight(RelevoCheck& check, PickScene& scene, const double point[3])
{
  double geographic[3];
  double coordinates[2];
  CHECK(scene.Mapper->WorldToGeographic(point, geographic));
  CHECK(scene.Pyramid->GeographicToRaster(geographic, coordinates));
  const double height = scene.Pyramid->GetElevation(coordinates[0], coordinates[1]);
  return scene.GetPixels(std::abs(height - geographic[2]) * scene.Mapper->GetExaggeration(), point);
}

// The three pickers agree with each other and with the raster, and miss the sky.
void TestPositions(RelevoCheck& check, const std::string& file)
{
  PickScene scene(file);
  vtkNew<vtkTerrainMeshSource> mesh;
  mesh->SetPyramid(scene.Pyramid);
  mesh->SetCamera(scene.Renderer->GetActiveCamera());
  mesh->SetViewportSize(Width, Height);
  vtkNew<vtkCellPicker> cells;
  vtkNew<vtkWorldPointPicker> depths;
  vtkNew<vtkPropPicker> props;
  for (double exaggeration : { 1.0, 2.0 })
  {
    CHECK_CASE(exaggeration);
    scene.Mapper->SetExaggeration(exaggeration);
    scene.Look(exaggeration * 300.0);
    mesh->SetExaggeration(exaggeration);
    mesh->Update();
    int found = 0;
    int missed = 0;
    double largest = 0.0;
    double difference = 0.0;
    for (int y = 5; y < Height; y += 23)
    {
      for (int x = 5; x < Width; x += 31)
      {
        // The depth is that of the pixel's centre.
        const bool isHit = cells->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer) != 0;
        CHECK_EQUAL(props->Pick(x, y, 0.0, scene.Renderer) != 0, isHit);
        missed += isHit ? 0 : 1;
        if (!isHit)
        {
          continue;
        }
        ++found;
        CHECK_EQUAL(cells->GetActor(), scene.Actor);
        CHECK_EQUAL(props->GetActor(), scene.Actor);
        depths->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer);
        double point[3];
        cells->GetPickPosition(point);
        largest = std::max(largest, MeasureHeight(check, scene, point));
        largest = std::max(largest, MeasureHeight(check, scene, depths->GetPickPosition()));
        difference = std::max(difference,
          scene.GetPixels(
            std::sqrt(vtkMath::Distance2BetweenPoints(point, depths->GetPickPosition())), point));
        // The cell is a triangle that is drawn, and contains the point.
        auto* data = vtkPolyData::SafeDownCast(cells->GetDataSet());
        CHECK_EQUAL(data->GetNumberOfCells(), mesh->GetOutput()->GetNumberOfCells());
        vtkCell* cell = data->GetCell(cells->GetCellId());
        double closest[3];
        double pcoords[3];
        double weights[3];
        double squared = 1.0;
        int subId = 0;
        cell->EvaluatePosition(point, closest, subId, pcoords, squared, weights);
        CHECK_LESS(squared, 1e-6);
        for (int i = 0; i < 3; ++i)
        {
          const double* expected =
            mesh->GetOutput()->GetCell(cells->GetCellId())->GetPoints()->GetPoint(i);
          CHECK_EQUAL(expected[2], cell->GetPoints()->GetPoint(i)[2]);
        }
      }
    }
    std::cout << found << " picks, " << missed << " missed, error " << largest
              << " pixels, difference of pickers " << difference << " pixels\n";
    CHECK_GREATER(found, 50);
    CHECK_GREATER(missed, 5);
    CHECK_LESS(largest, 1.05);
    CHECK_LESS(difference, 0.1);
  }
}

// The data of the pick follow the view, and the actor's matrix is applied.
void TestViews(RelevoCheck& check, const std::string& file)
{
  PickScene scene(file);
  vtkNew<vtkCellPicker> picker;
  CHECK(picker->Pick(160.0, 60.0, 0.0, scene.Renderer));
  const vtkIdType before = picker->GetDataSet()->GetNumberOfCells();
  CHECK(picker->GetDataSet()->GetPointData()->GetArray("Height"));
  CHECK_GREATER(std::abs(picker->GetPickNormal()[2]), 0.5);
  CHECK(!scene.Mapper->GetInput() || scene.Mapper->GetInput()->GetNumberOfPoints() == 0);
  scene.Look(2000.0);
  CHECK(picker->Pick(160.0, 60.0, 0.0, scene.Renderer));
  CHECK_NOT_EQUAL(picker->GetDataSet()->GetNumberOfCells(), before);
  double expected[3];
  picker->GetPickPosition(expected);
  scene.Actor->SetPosition(100.0, 200.0, 900.0);
  scene.Window->Render();
  vtkNew<vtkWorldPointPicker> depths;
  depths->Pick(160.5, 60.5, 0.0, scene.Renderer);
  CHECK(picker->Pick(160.5, 60.5, 0.0, scene.Renderer));
  double moved[3];
  picker->GetPickPosition(moved);
  CHECK_GREATER(std::sqrt(vtkMath::Distance2BetweenPoints(expected, moved)), 500.0);
  CHECK_LESS(scene.GetPixels(
               std::sqrt(vtkMath::Distance2BetweenPoints(moved, depths->GetPickPosition())), moved),
    4.0);
  scene.Actor->SetPosition(0.0, 0.0, 0.0);
  // A clipping plane removes what lies before it.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetNormal(0.0, 1.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  scene.Window->Render();
  CHECK(!picker->Pick(160.0, 5.0, 0.0, scene.Renderer));
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Window->Render();
  CHECK(picker->Pick(160.0, 5.0, 0.0, scene.Renderer));
}

void TestOthers(RelevoCheck& check, const std::string& file)
{
  PickScene scene(file);
  vtkNew<vtkPointPicker> points;
  points->SetTolerance(0.01);
  CHECK(points->Pick(160.0, 60.0, 0.0, scene.Renderer));
  CHECK_GREATER_EQUAL(points->GetPointId(), 0);
  CHECK_LESS(MeasureHeight(check, scene, points->GetPickPosition()), 1.05);
#if __has_include(<vtkHardwarePicker.h>)
  vtkNew<vtkHardwarePicker> hardware;
  CHECK(hardware->Pick(160.0, 60.0, 0.0, scene.Renderer)); // has no position, see the page
#endif
  // Nothing is picked before the first frame, and without a raster.
  vtkNew<vtkTerrainMapper> other;
  scene.Actor->SetMapper(other);
  RelevoErrors errors(other);
  vtkNew<vtkCellPicker> picker;
  CHECK(!picker->Pick(160.0, 60.0, 0.0, scene.Renderer));
  other->SetPyramid(scene.Pyramid);
  other->SetLoadingModeToComplete();
  CHECK(!picker->Pick(160.0, 60.0, 0.0, scene.Renderer));
  scene.Window->Render();
  CHECK(picker->Pick(160.0, 60.0, 0.0, scene.Renderer));
  CHECK(errors.Said("SetPyramid()"));
}

// Rectangles select the actor by its bounds, by what is seen, and by the pixels of a hardware
// selection.
void TestAreas(RelevoCheck& check, const std::string& file)
{
  PickScene scene(file);
  vtkNew<vtkAreaPicker> bounds;
  vtkNew<vtkRenderedAreaPicker> rendered;
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  struct Area
  {
    unsigned int Left;
    unsigned int Bottom;
    unsigned int Right;
    unsigned int Top;
    bool HasTerrain;
  };
  for (const Area& area :
    { Area{ 0, 0, Width - 1, Height - 1, true }, Area{ 150, 50, 170, 70, true },
      Area{ 160, 60, 160, 60, true }, Area{ 0, Height - 4, 20, Height - 1, false } })
  {
    CHECK_CASE(std::to_string(area.Left) + " " + std::to_string(area.Bottom));
    CHECK_EQUAL(bounds->AreaPick(
                  area.Left, area.Bottom, area.Right + 1.0, area.Top + 1.0, scene.Renderer) != 0,
      area.HasTerrain);
    CHECK_EQUAL(
      rendered->AreaPick(area.Left, area.Bottom, area.Right, area.Top, scene.Renderer) != 0,
      area.HasTerrain);
    if (area.HasTerrain)
    {
      CHECK_EQUAL(bounds->GetActor(), scene.Actor);
      CHECK_EQUAL(rendered->GetActor(), scene.Actor);
      CHECK_EQUAL(rendered->GetMapper(), scene.Mapper);
    }
    selector->SetArea(area.Left, area.Bottom, area.Right, area.Top);
    vtkIdType last = -1;
    for (const int association :
      { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
    {
      CHECK_CASE(association);
      selector->SetFieldAssociation(association);
      const auto selection = vtk::TakeSmartPointer(selector->Select());
      const bool isCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
      CHECK_EQUAL(selection->GetNumberOfNodes() > 0, area.HasTerrain && isCells);
      if (selection->GetNumberOfNodes() == 0)
      {
        continue;
      }
      vtkSelectionNode* node = selection->GetNode(0);
      CHECK_EQUAL(node->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor);
      auto* faces = vtkArrayDownCast<vtkIdTypeArray>(node->GetSelectionList());
      for (vtkIdType i = 0; faces && i < faces->GetNumberOfTuples(); ++i)
      {
        CHECK_GREATER(faces->GetValue(i), last);
        CHECK_LESS(faces->GetValue(i), scene.Mapper->GetNumberOfDrawnTriangles() / 64);
        last = faces->GetValue(i);
      }
      CHECK_GREATER(last, -1);
    }
  }
  // An actor that is not pickable is not found.
  scene.Actor->PickableOff();
  CHECK(!rendered->AreaPick(150.0, 50.0, 170.0, 70.0, scene.Renderer));
  scene.Actor->PickableOn();
  CHECK(rendered->AreaPick(150.0, 50.0, 170.0, 70.0, scene.Renderer));
}
}

int TestTerrainMapperPicks(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = WriteHills(folders);
  if (!CHECK(!file.empty()))
  {
    return check.GetResult();
  }
  TestPositions(check, file);
  TestViews(check, file);
  TestOthers(check, file);
  TestAreas(check, file);
  return check.GetResult();
}
