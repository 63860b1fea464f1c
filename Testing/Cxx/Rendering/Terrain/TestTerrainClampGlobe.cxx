// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainClamp lays lines and polygons on the triangles of a globe, also across the meridian at
// which the raster begins.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkStaticCellLocator.h"
#include "vtkTerrainClamp.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace
{
constexpr int WindowSize = 300;

std::string WriteGlobe(const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 720;
  raster.Height = 360;
  raster.Transform = { -180.0, 0.5, 0.0, 90.0, 0.0, -0.5 };
  raster.CoordinateSystem = "EPSG:4326";
  raster.SetValues(
    [](int, int column, int row)
    {
      const double longitude = vtkMath::RadiansFromDegrees(0.5 * column);
      const double latitude = vtkMath::RadiansFromDegrees(0.5 * row);
      return 3000.0 * std::sin(9.0 * longitude) * std::sin(7.0 * latitude) +
        2000.0 * std::sin(31.0 * longitude) * std::sin(latitude);
    });
  const std::string file = folders.File("TerrainClampGlobe.tif");
  const bool isWritten = raster.Write(file);
  std::filesystem::remove(file + ".relevo-index");
  return isWritten ? file : "";
}

using Place = std::array<double, 2>;

// A line or a polygon. In world coordinates if there is a mapper.
vtkSmartPointer<vtkPolyData> MakeCell(
  const std::vector<Place>& places, bool isPolygon, vtkTerrainMapper* mapper = nullptr)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cell;
  cell->InsertNextCell(static_cast<int>(places.size()));
  for (const Place& place : places)
  {
    const double geographic[3] = { place[0], place[1], 12345.0 };
    double point[3] = { place[0], place[1], 0.0 };
    if (mapper)
    {
      mapper->GeographicToWorld(geographic, point);
    }
    cell->InsertCellPoint(points->InsertNextPoint(point));
  }
  data->SetPoints(points);
  if (isPolygon)
  {
    data->SetPolys(cell);
  }
  else
  {
    data->SetLines(cell);
  }
  return data;
}

class GlobeClampScene : public RelevoPyramidScene
{
public:
  explicit GlobeClampScene(const std::string& file)
    : RelevoPyramidScene(file, WindowSize, WindowSize)
  {
    this->Mapper->SetFrameToGeocentric();
    this->Actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Clamp->SetMapper(this->Mapper);
    this->Clamp->SetCoordinateTypeToGeographic();
    this->CellMapper->SetInputConnection(this->Clamp->GetOutputPort());
    this->CellActor->SetMapper(this->CellMapper);
    this->CellActor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    this->CellActor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->CellActor);
    this->Mesh->SetPyramid(this->Pyramid);
    this->Mesh->SetFrameToGeocentric();
    this->Mesh->SetCamera(this->Renderer->GetActiveCamera());
    this->Mesh->SetViewportSize(WindowSize, WindowSize);
  }

  void Look(double longitude, double latitude, double height)
  {
    const double geographic[3] = { longitude, latitude, height };
    double eye[3];
    this->Mapper->GeographicToWorld(geographic, eye);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
  }

  bool IsInView(const double point[3])
  {
    double view[3] = { point[0], point[1], point[2] };
    this->Renderer->WorldToView(view[0], view[1], view[2]);
    // The other side of the globe is hidden.
    double normal[3] = { point[0], point[1], point[2] };
    vtkMath::Normalize(normal);
    const double* eye = this->Renderer->GetActiveCamera()->GetPosition();
    return std::abs(view[0]) < 0.9 && std::abs(view[1]) < 0.9 && vtkMath::Dot(normal, eye) > 6.5e6;
  }

  vtkNew<vtkTerrainClamp> Clamp;
  vtkNew<vtkPolyDataMapper> CellMapper;
  vtkNew<vtkActor> CellActor;
  vtkNew<vtkTerrainMeshSource> Mesh;
};

// The largest distance of points in view from the triangles that are drawn, and their number.
double MeasureGlobeDistance(GlobeClampScene& scene, int& number)
{
  scene.Mesh->Update();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(scene.Mesh->GetOutput());
  locator->BuildLocator();
  vtkPolyData* output = scene.Clamp->GetOutput();
  double largest = 0.0;
  number = 0;
  for (vtkIdType id = 0; id < output->GetNumberOfCells(); ++id)
  {
    vtkPoints* points = output->GetCell(id)->GetPoints();
    for (vtkIdType i = 1; i < points->GetNumberOfPoints(); ++i)
    {
      for (double t : { 0.0, 0.4 })
      {
        double p[2][3];
        points->GetPoint(i - 1, p[0]);
        points->GetPoint(i, p[1]);
        for (int axis = 0; axis < 3; ++axis)
        {
          p[0][axis] += t * (p[1][axis] - p[0][axis]);
        }
        if (scene.IsInView(p[0]))
        {
          double closest[3];
          vtkIdType cell = -1;
          int subId = 0;
          double squared = 0.0;
          locator->FindClosestPoint(p[0], closest, cell, subId, squared);
          largest = std::max(largest, std::sqrt(squared));
          ++number;
        }
      }
    }
  }
  return largest;
}

const std::vector<Place> Track = { { { 160.0, -12.0 } }, { { -172.0, 3.0 } }, { { -165.0, 14.0 } },
  { { 178.0, 9.0 } } };
const std::vector<Place> Area = { { { 168.0, -9.0 } }, { { -168.0, -6.0 } }, { { 179.0, 12.0 } } };

void TestCells(RelevoCheck& check, GlobeClampScene& scene)
{
  for (bool isPolygon : { false, true })
  {
    for (double height : { 9e6, 1.5e6 })
    {
      CHECK_CASE(height);
      scene.Clamp->SetInputData(MakeCell(isPolygon ? Area : Track, isPolygon));
      scene.Clamp->SetOffset(0.0);
      scene.Look(179.0, 2.0, height);
      int number = 0;
      const double distance = MeasureGlobeDistance(scene, number);
      vtkPolyData* output = scene.Clamp->GetOutput();
      std::cout << (isPolygon ? "area" : "track") << ", height " << height << ": distance "
                << distance << " of " << number << " points, " << output->GetNumberOfCells()
                << " cells\n";
      CHECK_LESS(distance, 1e-3);
      CHECK_GREATER(number, 15);
      // The raster begins between the points; the line crosses its first column twice.
      CHECK(isPolygon || output->GetNumberOfCells() == 3);
      for (vtkIdType id = 0; id < output->GetNumberOfCells() && isPolygon; ++id)
      {
        double normal[3];
        double point[3];
        output->GetPoint(output->GetCell(id)->GetPointId(0), point);
        vtkPolygon::ComputeNormal(output->GetCell(id)->GetPoints(), normal);
        CHECK_GREATER(vtkMath::Dot(normal, point), 0.0);
      }
    }
  }
}

// World coordinates give the same, and the offset is upwards.
void TestWorld(RelevoCheck& check, GlobeClampScene& scene)
{
  scene.Clamp->SetInputData(MakeCell(Track, false));
  scene.Look(179.0, 2.0, 9e6);
  vtkPolyData* output = scene.Clamp->GetOutput();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(output);
  scene.Clamp->SetInputData(MakeCell(Track, false, scene.Mapper));
  scene.Clamp->SetCoordinateTypeToWorld();
  scene.Clamp->SetOffset(1000.0);
  scene.Clamp->Update();
  CHECK_EQUAL(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < std::min(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
       ++i)
  {
    double a[3];
    double b[3];
    output->GetPoint(i, a);
    expected->GetPoint(i, b);
    CHECK_NEAR(vtkMath::Norm(a) - vtkMath::Norm(b), 1000.0, 0.1);
    CHECK_NEAR(std::sqrt(vtkMath::Distance2BetweenPoints(a, b)), 1000.0, 0.1);
  }
  scene.Clamp->SetCoordinateTypeToGeographic();
}

// A line with an offset is nowhere hidden by the globe below it.
void TestGlobePicture(RelevoCheck& check, GlobeClampScene& scene, const RelevoTestFolders& folders)
{
  scene.Clamp->SetInputData(MakeCell(Track, false));
  scene.Clamp->SetOffset(40000.0); // a pixel and a half
  scene.Look(179.0, 2.0, 9e6);
  const size_t visible = scene.CountRed();
  RelevoPicture(scene.Window).Save(folders.File("TerrainClampGlobe.png"));
  scene.Actor->VisibilityOff();
  const size_t all = scene.CountRed();
  scene.Actor->VisibilityOn();
  std::cout << "pixels of the track: " << visible << " of " << all << "\n";
  CHECK_GREATER(all, 150);
  CHECK_EQUAL(visible, all);
}
}

int TestTerrainClampGlobe(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = WriteGlobe(folders);
  if (!CHECK(!file.empty()))
  {
    return check.GetResult();
  }
  GlobeClampScene scene(file);
  RelevoErrors warnings(scene.Clamp);
  TestCells(check, scene);
  TestWorld(check, scene);
  TestGlobePicture(check, scene, folders);
  CHECK(warnings.None());
  return check.GetResult();
}
