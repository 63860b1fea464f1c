// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainClamp lays polydata on the terrain as it is drawn, which vtkTerrainMeshSource outputs
// for the same camera, or on the surface of full resolution, which the test evaluates itself.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "Draping/RasterSurface.h"
#include "Draping/TerrainDraping.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFeatureEdges.h"
#include "vtkIntArray.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTerrainClamp.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

namespace
{
constexpr int Size = 301;
constexpr double Spacing = 20.0;
constexpr double Half = 0.5 * Spacing * (Size - 1);
constexpr double NotFound = std::numeric_limits<double>::quiet_NaN();

RelevoRaster MakeRaster()
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, Spacing);
  raster.SetValues(
    [](int, int column, int row)
    {
      return std::round(8.0 *
               (400.0 + 300.0 * std::sin(column / 30.0) * std::cos(row / 40.0) +
                 60.0 * std::sin(column / 9.0 + row / 14.0) + 6.0 * std::cos(column * 1.3 - row))) /
        8.0;
    });
  return raster;
}

// Bilinear between the centres of samples, at a point of the map frame.
double GetTruth(const RelevoRaster& raster, double x, double y)
{
  const double column = std::clamp((x + Half) / Spacing, 0.0, Size - 1.0);
  const double row = std::clamp((Half - y) / Spacing, 0.0, Size - 1.0);
  const int i = std::min(static_cast<int>(column), Size - 2);
  const int j = std::min(static_cast<int>(row), Size - 2);
  double sum = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    sum += (corner % 2 ? column - i : 1.0 - column + i) * (corner / 2 ? row - j : 1.0 - row + j) *
      raster.At(0, i + corner % 2, j + corner / 2);
  }
  return sum;
}

// The heights of triangles over the map.
class MeshHeights
{
public:
  explicit MeshHeights(vtkPolyData* mesh)
    : Mesh(mesh)
    , Bins(Number * Number)
  {
    for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
    {
      double box[6];
      mesh->GetCellBounds(id, box);
      for (int j = ToBin(box[2]); j <= ToBin(box[3]); ++j)
      {
        for (int i = ToBin(box[0]); i <= ToBin(box[1]); ++i)
        {
          this->Bins[j * Number + i].push_back(id);
        }
      }
    }
  }

  // NaN outside of the triangles.
  double Get(double x, double y) const
  {
    for (vtkIdType id : this->Bins[ToBin(y) * Number + ToBin(x)])
    {
      double p[3][3];
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      this->Mesh->GetCellPoints(id, count, points);
      for (int i = 0; i < 3; ++i)
      {
        this->Mesh->GetPoint(points[i], p[i]);
      }
      const auto turn = [](const double* a, const double* b, double cx, double cy)
      { return (b[0] - a[0]) * (cy - a[1]) - (b[1] - a[1]) * (cx - a[0]); };
      const double area = turn(p[0], p[1], p[2][0], p[2][1]);
      const double w[3] = { turn(p[1], p[2], x, y) / area, turn(p[2], p[0], x, y) / area,
        turn(p[0], p[1], x, y) / area };
      if (*std::min_element(w, w + 3) >= -1e-9)
      {
        return w[0] * p[0][2] + w[1] * p[1][2] + w[2] * p[2][2];
      }
    }
    return NotFound;
  }

private:
  static constexpr int Number = 128;
  static int ToBin(double x)
  {
    return static_cast<int>(std::clamp((x / Half + 1.0) * Number / 2.0, 0.0, Number - 1.0));
  }

  vtkPolyData* Mesh;
  std::vector<std::vector<vtkIdType>> Bins;
};

using Point = std::array<double, 2>;

// Lines of these points. Point data are a linear function of position, cell data are numbers.
vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<std::vector<Point>>& lines)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> linear;
  linear->SetName("Linear");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (const auto& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    numbers->InsertNextValue(7 + static_cast<int>(numbers->GetNumberOfValues()));
    for (const Point& point : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point[0], point[1], -1e4));
      linear->InsertNextValue(3.0 * point[0] - point[1]);
    }
  }
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetPointData()->AddArray(linear);
  data->GetCellData()->AddArray(numbers);
  return data;
}

vtkSmartPointer<vtkPolyData> MakeRandomLines(int number)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-0.99 * Half, 0.99 * Half);
  std::vector<std::vector<Point>> lines(static_cast<size_t>(number));
  for (auto& line : lines)
  {
    for (int i = 0; i < 4; ++i)
    {
      line.push_back({ { uniform(random), uniform(random) } });
    }
  }
  // Along edges of triangles: a row of samples, a diagonal, and the border.
  lines.push_back({ { { -Half, 0.0 } }, { { Half, 0.0 } } });
  lines.push_back({ { { -Half, Half } }, { { Half, -Half } } });
  lines.push_back({ { { -Half, -Half } }, { { Half, -Half } }, { { Half, Half } } });
  return MakeLines(lines);
}

// A star with notches, counter-clockwise, and the same clockwise.
vtkSmartPointer<vtkPolyData> MakeStars()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int star = 0; star < 2; ++star)
  {
    cells->InsertNextCell(14);
    for (int i = 0; i < 14; ++i)
    {
      const double angle = (star == 0 ? 1.0 : -1.0) * (0.1 + i * vtkMath::Pi() / 7.0);
      const double radius = i % 2 == 0 ? 0.45 * Half : 0.2 * Half;
      cells->InsertCellPoint(points->InsertNextPoint(
        (star - 0.5) * Half + radius * std::cos(angle), radius * std::sin(angle), 5.0));
    }
  }
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

// The length of lines on the map.
double MeasureLength(vtkPolyData* data)
{
  double length = 0.0;
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    vtkPoints* points = data->GetCell(id)->GetPoints();
    for (vtkIdType i = 1; i < points->GetNumberOfPoints(); ++i)
    {
      double a[3];
      double b[3];
      points->GetPoint(i - 1, a);
      points->GetPoint(i, b);
      length += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  }
  return length;
}

// The signed area of polygons on the map; the smallest one, and the sum.
std::array<double, 2> MeasureArea(vtkPolyData* data)
{
  double smallest = std::numeric_limits<double>::max();
  double sum = 0.0;
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    vtkPoints* points = data->GetCell(id)->GetPoints();
    const vtkIdType count = points->GetNumberOfPoints();
    double area = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      double a[3];
      double b[3];
      points->GetPoint(i, a);
      points->GetPoint((i + 1) % count, b);
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    smallest = std::min(smallest, area);
    sum += area;
  }
  return { { smallest, sum } };
}

// Calls the function with points of all cells: along lines, and inside of polygons.
template <typename Function>
void ForPoints(vtkPolyData* data, const Function& function)
{
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    vtkPoints* points = data->GetCell(id)->GetPoints();
    const bool isLine = data->GetCellType(id) == VTK_LINE || data->GetCellType(id) == VTK_POLY_LINE;
    for (vtkIdType i = 1; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3][3];
      points->GetPoint(0, p[0]);
      points->GetPoint(i - 1, p[1]);
      points->GetPoint(i, p[2]);
      for (double t : { 0.0, 0.31, 0.5, 1.0 })
      {
        double q[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          q[axis] = (1.0 - t) * p[1][axis] + t * p[2][axis];
          q[axis] = isLine ? q[axis] : 0.7 * q[axis] + 0.3 * p[0][axis];
        }
        function(q);
      }
    }
  }
}

class ClampScene : public RelevoPyramidScene
{
public:
  explicit ClampScene(const std::string& file)
    : RelevoPyramidScene(file)
  {
    this->Actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Clamp->SetMapper(this->Mapper);
    this->LineMapper->SetInputConnection(this->Clamp->GetOutputPort());
    this->LineMapper->ScalarVisibilityOff();
    this->LineActor->SetMapper(this->LineMapper);
    this->LineActor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    this->LineActor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->LineActor);
    this->Mesh->SetPyramid(this->Pyramid);
    this->Mesh->SetCamera(this->Renderer->GetActiveCamera());
    this->Mesh->SetViewportSize(400, 300);
  }

  void Look(double x, double y, double height)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x, y, height);
    camera->SetFocalPoint(0.2 * Half, 0.1 * Half, 300.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
  }

  // The triangles that the mapper has drawn.
  vtkPolyData* UpdateMesh(RelevoCheck& check)
  {
    this->Mesh->SetExaggeration(this->Mapper->GetExaggeration());
    this->Mesh->SetScreenSpaceError(this->Mapper->GetScreenSpaceError());
    this->Mesh->Update();
    CHECK_EQUAL(this->Mesh->GetScreenSpaceErrorInUse(), this->Mapper->GetScreenSpaceErrorInUse());
    return this->Mesh->GetOutput();
  }

  vtkNew<vtkTerrainClamp> Clamp;
  vtkNew<vtkPolyDataMapper> LineMapper;
  vtkNew<vtkActor> LineActor;
  vtkNew<vtkTerrainMeshSource> Mesh;
};

// The number of cells is limited.
void TestLimit(RelevoCheck& check, const std::string& file)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(file.c_str());
  CHECK(pyramid->Update());
  const auto lattice = pyramid->GetLattice();
  const auto stars = MakeStars();
  std::vector<relevo::MapPosition> positions;
  for (vtkIdType i = 0; i < stars->GetNumberOfPoints(); ++i)
  {
    positions.push_back(
      { { (stars->GetPoint(i)[0] + Half) / Spacing, (stars->GetPoint(i)[1] + Half) / Spacing } });
  }
  for (const auto& [limit, expected] :
    { std::make_pair(1000, relevo::TerrainDraping::Result::TooManyCells),
      std::make_pair(1000000, relevo::TerrainDraping::Result::Done) })
  {
    CHECK_CASE(limit);
    relevo::RasterSurface surface(*lattice, relevo::TerrainPlacement(), 0.1);
    relevo::TerrainDraping::Settings settings;
    settings.MaximumCells = limit;
    relevo::TerrainDraping draping(surface, settings, stars, positions);
    vtkNew<vtkPolyData> output;
    CHECK(draping.Run(output) == expected);
    CHECK_LESS_EQUAL(output->GetNumberOfCells(), limit + 1);
  }
}

// The largest distance of points in view from the triangles that are drawn, and their number.
double MeasureDistance(ClampScene& scene, vtkPolyData* mesh, int& number)
{
  const MeshHeights heights(mesh);
  double largest = 0.0;
  number = 0;
  ForPoints(scene.Clamp->GetOutput(),
    [&](const double q[3])
    {
      double view[3] = { q[0], q[1], q[2] };
      scene.Renderer->WorldToView(view[0], view[1], view[2]);
      if (std::abs(view[0]) < 1.0 && std::abs(view[1]) < 1.0 && std::abs(view[2]) < 1.0)
      {
        ++number;
        const double distance = std::abs(q[2] - scene.Clamp->GetOffset() - heights.Get(q[0], q[1]));
        largest = distance <= largest ? largest : distance; // also NaN
      }
    });
  return largest;
}

// Each frame lays the input on the triangles that it draws.
void TestDrawn(RelevoCheck& check, const std::string& file)
{
  ClampScene scene(file);
  const auto lines = MakeRandomLines(40);
  const auto stars = MakeStars();
  vtkPolyData* output = scene.Clamp->GetOutput();
  for (const auto& input : { lines, stars })
  {
    const bool isLines = input == lines;
    scene.Clamp->SetInputData(input);
    const double length = MeasureLength(lines);
    const double area = std::abs(MeasureArea(stars)[0]) * 2.0;
    const double views[4][3] = { { -0.9 * Half, -1.6 * Half, 2500.0 }, { 0.0, 0.0, 900.0 },
      { 1.5 * Half, 0.4 * Half, 1200.0 }, { 0.0, -10.0, 12.0 * Half } };
    for (int view = 0; view < 4; ++view)
    {
      CHECK_CASE(view);
      scene.Clamp->SetOffset(view == 1 ? 12.5 : 0.0);
      scene.Mapper->SetExaggeration(view == 2 ? 2.0 : 1.0);
      scene.Mapper->SetScreenSpaceError(view == 3 ? 4.0 : 1.0);
      scene.Look(views[view][0], views[view][1], views[view][2]);
      scene.Window->Render(); // updates the filter
      vtkPolyData* mesh = scene.UpdateMesh(check);
      int found = 0;
      const double distance = MeasureDistance(scene, mesh, found);
      std::cout << (isLines ? "lines" : "stars") << ", view " << view << ": distance " << distance
                << " of " << found << " points, " << mesh->GetNumberOfCells() << " triangles, "
                << output->GetNumberOfCells() << " cells\n";
      CHECK_LESS(distance, 1e-6);
      CHECK_GREATER(found, 500);
      // Parts that are out of sight are complete, too.
      if (isLines)
      {
        CHECK_NEAR(MeasureLength(output) / length, 1.0, 1e-9);
        CHECK_EQUAL(output->GetNumberOfCells(), input->GetNumberOfCells());
      }
      else
      {
        CHECK_NEAR(MeasureArea(output)[1] / area, 1.0, 1e-9);
        CHECK_GREATER(MeasureArea(output)[0], -1e-9);
      }
    }
  }
}

// Neighbouring parts of a polygon share their points: only its outline is open.
void TestOutline(RelevoCheck& check, const std::string& file)
{
  ClampScene scene(file);
  const auto stars = MakeStars();
  scene.Clamp->SetInputData(stars);
  scene.Look(0.0, -10.0, 8.0 * Half);
  scene.Window->Render();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(scene.Clamp->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->BoundaryEdgesOn();
  edges->Update();
  double perimeter = 0.0;
  for (int i = 0; i < 14; ++i)
  {
    perimeter += 2.0 *
      std::sqrt(vtkMath::Distance2BetweenPoints(stars->GetPoint(i),
        &std::array<double, 3>(
          { { stars->GetPoint((i + 1) % 14)[0], stars->GetPoint((i + 1) % 14)[1], 5.0 } })[0]));
  }
  CHECK_NEAR(MeasureLength(edges->GetOutput()) / perimeter, 1.0, 1e-6);
}

// A line with an offset of a pixel is nowhere hidden by the terrain below it.
void TestPicture(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  ClampScene scene(file);
  scene.Clamp->SetInputData(MakeRandomLines(10));
  // From straight above, and low hills from the side, which do not hide each other.
  const double views[3][3] = { { 0.1 * Half, 3.0 * Half, 1.0 }, { 0.1 * Half, 0.8 * Half, 1.0 },
    { -1.5 * Half, 1.5 * Half, 0.1 } };
  for (const auto& view : views)
  {
    CHECK_CASE(view[0]);
    scene.Mapper->SetExaggeration(view[2]);
    scene.Look(0.2 * Half, view[0] - 10.0, view[1]);
    scene.Clamp->SetOffset(view[1] * 2.0 * std::tan(vtkMath::RadiansFromDegrees(15.0)) / 300.0);
    const size_t visible = scene.CountRed();
    RelevoPicture(scene.Window).Save(folders.File("TerrainClamp.png"));
    scene.Actor->VisibilityOff();
    const size_t all = scene.CountRed();
    scene.Actor->VisibilityOn();
    std::cout << "pixels of lines: " << visible << " of " << all << "\n";
    CHECK_GREATER(all, 1000);
    CHECK_EQUAL(visible, all);
  }
}

void TestFullResolution(RelevoCheck& check, const RelevoRaster& raster, const std::string& file)
{
  ClampScene scene(file);
  scene.Clamp->SetMapper(nullptr);
  scene.Clamp->SetPyramid(scene.Pyramid);
  const auto lines = MakeRandomLines(20);
  const auto stars = MakeStars();
  for (const auto& input : { lines, stars })
  {
    scene.Clamp->SetInputData(input);
    vtkIdType last = 0;
    for (double error : { 1.0, 0.1, 0.01 })
    {
      if (input == stars && error < 0.1)
      {
        continue; // millions of triangles
      }
      CHECK_CASE(error);
      scene.Clamp->SetMaximumError(error);
      scene.Clamp->SetExaggeration(error == 0.1 ? -2.0 : 1.0);
      scene.Clamp->SetOffset(error == 0.1 ? 3.0 : 0.0);
      scene.Clamp->Update();
      vtkPolyData* output = scene.Clamp->GetOutput();
      const double factor = scene.Clamp->GetExaggeration();
      double largest = 0.0;
      ForPoints(output,
        [&](const double q[3])
        {
          const double height = (q[2] - scene.Clamp->GetOffset()) / factor;
          largest = std::max(largest, std::abs(height - GetTruth(raster, q[0], q[1])));
        });
      vtkDataArray* heights = output->GetPointData()->GetArray("Height");
      double atPoints = 0.0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const double* q = output->GetPoint(i);
        atPoints =
          std::max(atPoints, std::abs(heights->GetTuple1(i) - GetTruth(raster, q[0], q[1])));
      }
      std::cout << "full resolution: error " << largest << " of " << error << ", at points "
                << atPoints << ", " << output->GetNumberOfPoints() << " points\n";
      CHECK_LESS_EQUAL(largest, error + 1e-6);
      CHECK_LESS_EQUAL(atPoints, input == lines ? 1e-6 : error + 1e-6);
      CHECK_GREATER(output->GetNumberOfPoints(), last);
      last = output->GetNumberOfPoints();
    }
  }
}

void TestAttributes(RelevoCheck& check, const std::string& file)
{
  ClampScene scene(file);
  const auto lines = MakeRandomLines(5);
  scene.Clamp->SetInputData(lines);
  scene.Look(-0.9 * Half, -1.6 * Half, 2500.0);
  scene.Window->Render();
  vtkPolyData* output = scene.Clamp->GetOutput();
  vtkDataArray* linear = output->GetPointData()->GetArray("Linear");
  double largest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    largest = std::max(largest, std::abs(linear->GetTuple1(i) - 3.0 * p[0] + p[1]));
  }
  CHECK_LESS(largest, 1e-5);
  vtkDataArray* numbers = output->GetCellData()->GetArray("Number");
  for (vtkIdType id = 0; id < output->GetNumberOfCells(); ++id)
  {
    CHECK_EQUAL(numbers->GetTuple1(id), 7.0 + id);
    // The ends are those of the input.
    for (bool isEnd : { false, true })
    {
      vtkPoints* actual = output->GetCell(id)->GetPoints();
      double a[3];
      actual->GetPoint(isEnd ? actual->GetNumberOfPoints() - 1 : 0, a);
      vtkPoints* expected = lines->GetCell(id)->GetPoints();
      double b[3];
      expected->GetPoint(isEnd ? expected->GetNumberOfPoints() - 1 : 0, b);
      CHECK_NEAR(a[0], b[0], 1e-6);
      CHECK_NEAR(a[1], b[1], 1e-6);
    }
  }
  // Vertices, lines and polygons of one input keep their order.
  vtkNew<vtkPolyData> all;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : { Point{ { 0.0, 0.0 } }, Point{ { 500.0, 0.0 } }, Point{ { 0.0, 500.0 } },
         Point{ { 500.0, 500.0 } } })
  {
    points->InsertNextPoint(p[0], p[1], 0.0);
  }
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  all->SetPoints(points);
  all->AllocateExact(4, 10);
  all->InsertNextCell(VTK_POLY_VERTEX, 4, ids);
  all->InsertNextCell(VTK_LINE, 2, ids);
  all->InsertNextCell(VTK_LINE, 2, ids + 1);
  all->InsertNextCell(VTK_TRIANGLE_STRIP, 4, ids);
  vtkNew<vtkIntArray> cells;
  cells->SetName("Number");
  for (int i = 0; i < 4; ++i)
  {
    cells->InsertNextValue(i);
  }
  all->GetCellData()->AddArray(cells);
  scene.Clamp->SetInputData(all);
  scene.Clamp->Update();
  CHECK_EQUAL(output->GetNumberOfVerts(), 1);
  CHECK_EQUAL(output->GetCell(0)->GetNumberOfPoints(), 4);
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  CHECK_EQUAL(output->GetCell(1)->GetPointId(0), output->GetCell(0)->GetPointId(0)); // shared
  CHECK_GREATER(output->GetNumberOfPolys(), 20);
  numbers = output->GetCellData()->GetArray("Number");
  for (vtkIdType id = 0; id < output->GetNumberOfCells(); ++id)
  {
    CHECK_EQUAL(numbers->GetTuple1(id), std::min<double>(3.0, static_cast<double>(id)));
  }
}

// Coordinates of the raster and longitudes and latitudes give the same as those of the map.
void TestCoordinates(RelevoCheck& check, const std::string& file)
{
  ClampScene scene(file);
  scene.Clamp->SetMapper(nullptr);
  scene.Clamp->SetPyramid(scene.Pyramid);
  const std::vector<Point> world = { { { -1000.0, -500.0 } }, { { 700.0, 200.0 } },
    { { 900.0, -2000.0 } } };
  std::vector<Point> raster;
  std::vector<Point> geographic;
  for (const Point& point : world)
  {
    raster.push_back({ { point[0] + 500000.0 + 0.5 * Size * Spacing,
      point[1] + 4300000.0 - 0.5 * Size * Spacing } });
    const double position[3] = { point[0], point[1], 0.0 };
    double place[3];
    CHECK(scene.Mapper->WorldToGeographic(position, place));
    geographic.push_back({ { place[0], place[1] } });
  }
  vtkPolyData* output = scene.Clamp->GetOutput();
  scene.Clamp->SetInputData(MakeLines({ world }));
  scene.Clamp->Update();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(output);
  CHECK_GREATER(expected->GetNumberOfPoints(), 300);
  for (int type : { vtkTerrainClamp::RASTER, vtkTerrainClamp::GEOGRAPHIC })
  {
    CHECK_CASE(type);
    scene.Clamp->SetInputData(MakeLines({ type == vtkTerrainClamp::RASTER ? raster : geographic }));
    scene.Clamp->SetCoordinateType(type);
    scene.Clamp->Update();
    CHECK_NEAR(MeasureLength(output), MeasureLength(expected), 1e-2);
    double bounds[6];
    output->GetBounds(bounds);
    for (int i = 0; i < 6; ++i)
    {
      CHECK_NEAR(bounds[i], expected->GetBounds()[i], 1e-2);
    }
  }
}

// Rasters that are rotated, mirrored or have south above. Point data that are the coordinates of
// the raster tell where its height is.
void TestTransforms(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const double transforms[3][6] = { { 1000.0, 17.0, 5.0, 2000.0, 4.0, -19.0 },
    { 9000.0, -20.0, 0.0, 2000.0, 0.0, -20.0 }, { 1000.0, 3.0, 18.0, 9000.0, 21.0, -2.0 } };
  for (const auto& transform : transforms)
  {
    CHECK_CASE(transform[1]);
    RelevoRaster raster = MakeRaster();
    raster.Transform.assign(transform, transform + 6);
    const std::string file = folders.File("TerrainClampTurned.tif");
    CHECK(raster.Write(file));
    std::filesystem::remove(file + ".relevo-index");
    ClampScene scene(file);
    const auto stars = MakeStars();
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetName("Coordinates");
    coordinates->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < stars->GetNumberOfPoints(); ++i)
    {
      const double column = 0.5 * Size + stars->GetPoint(i)[0] / Spacing;
      const double row = 0.5 * Size + stars->GetPoint(i)[1] / Spacing;
      const double x = transform[0] + column * transform[1] + row * transform[2];
      const double y = transform[3] + column * transform[4] + row * transform[5];
      stars->GetPoints()->SetPoint(i, x, y, 0.0);
      coordinates->InsertNextTuple2(x, y);
    }
    stars->GetPointData()->AddArray(coordinates);
    stars->SetLines(stars->GetPolys());
    scene.Clamp->SetInputData(stars);
    scene.Clamp->SetCoordinateTypeToRaster();
    scene.Mapper->SetScreenSpaceError(0.05);
    scene.Look(0.0, -10.0, 6.0 * Half); // everything is in view
    vtkPolyData* output = scene.Clamp->GetOutput();
    for (bool isDrawn : { true, false })
    {
      CHECK_CASE(isDrawn);
      scene.Window->Render();
      CHECK(scene.Mapper->IsComplete());
      vtkDataArray* places = output->GetPointData()->GetArray("Coordinates");
      vtkDataArray* heights = output->GetPointData()->GetArray("Height");
      double largest = 0.0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const double height =
          scene.Pyramid->GetElevation(places->GetComponent(i, 0), places->GetComponent(i, 1));
        const double distance = std::abs(heights->GetTuple1(i) - height);
        largest = distance <= largest ? largest : distance; // also NaN
      }
      CHECK_GREATER(output->GetNumberOfPoints(), 1000);
      // 0.05 pixels of 32 m, from above.
      CHECK_LESS(largest, isDrawn ? 2.0 : 0.1 + 1e-6);
      vtkNew<vtkPolyData> polygons;
      polygons->SetPoints(output->GetPoints());
      polygons->SetPolys(output->GetPolys());
      CHECK_GREATER(MeasureArea(polygons)[0], -1e-9);
      scene.Clamp->SetMapper(nullptr);
      scene.Clamp->SetPyramid(scene.Pyramid);
    }
  }
}

// Lines in longitude and latitude take the shorter way.
void TestAntimeridian(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 60;
  raster.Height = 40;
  raster.Transform = { 150.0, 1.0, 0.0, 20.0, 0.0, -1.0 };
  raster.CoordinateSystem = "EPSG:4326";
  raster.SetValues([](int, int column, int) { return column; });
  const std::string file = folders.File("TerrainClampDateLine.tif");
  CHECK(raster.Write(file));
  ClampScene scene(file);
  scene.Clamp->SetMapper(nullptr);
  scene.Clamp->SetPyramid(scene.Pyramid);
  RelevoErrors warnings(scene.Clamp);
  vtkPolyData* output = scene.Clamp->GetOutput();
  for (const auto& line : { std::vector<Point>{ { { 170.0, 0.0 } }, { { -170.0, 0.0 } } },
         std::vector<Point>{ { { -170.0, 0.0 } }, { { 170.0, 0.0 } } },
         std::vector<Point>{ { { -190.0, 0.0 } }, { { -170.0, 0.0 } } } })
  {
    scene.Clamp->SetInputData(MakeLines({ line }));
    scene.Clamp->SetCoordinateTypeToGeographic();
    scene.Clamp->Update();
    CHECK_EQUAL(output->GetNumberOfCells(), 1);
    double heights[2];
    output->GetPointData()->GetArray("Height")->GetRange(heights);
    CHECK_NEAR(heights[0], 19.5, 1e-6);
    CHECK_NEAR(heights[1], 39.5, 1e-6);
  }
  CHECK(warnings.None());
}

// Parts outside and over missing data are left out, with one warning.
void TestMissing(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster();
  raster.NoData = -9999.0;
  for (int row = 100; row < 120; ++row)
  {
    std::fill_n(raster.Values.begin() + row * Size + 140, 20, -9999.0);
  }
  const std::string file = folders.File("TerrainClampHole.tif");
  CHECK(raster.Write(file));
  ClampScene scene(file);
  const double y = Half - 110.4 * Spacing;
  for (bool isDrawn : { true, false })
  {
    CHECK_CASE(isDrawn);
    vtkNew<vtkTerrainClamp> clamp;
    RelevoErrors warnings(clamp);
    if (isDrawn)
    {
      clamp->SetMapper(scene.Mapper);
    }
    else
    {
      clamp->SetPyramid(scene.Pyramid);
    }
    scene.LineMapper->SetInputConnection(clamp->GetOutputPort());
    clamp->SetInputData(MakeLines({ { { { -1.5 * Half, y } }, { { 1.5 * Half, y } } },
      { { { 2.0 * Half, 0.0 } }, { { 3.0 * Half, 0.0 } } } }));
    scene.Look(0.0, -10.0, 3.0 * Half);
    scene.Window->Render();
    CHECK(warnings.Warned("left out"));
    clamp->SetOffset(1.0);
    scene.Window->Render();
    CHECK(warnings.None()); // once
    vtkPolyData* output = clamp->GetOutput();
    CHECK_EQUAL(output->GetNumberOfCells(), 2);
    CHECK_NEAR(output->GetBounds()[0], -Half, 1e-6);
    CHECK_NEAR(output->GetBounds()[1], Half, 1e-6);
    // The hole has 21 cells, and larger triangles if it is drawn coarsely.
    CHECK_NEAR(MeasureLength(output), 2.0 * Half - 21.0 * Spacing, isDrawn ? 200.0 : 1e-6);
    // Points, and values that are not numbers.
    vtkNew<vtkPolyData> input;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(0.0, 0.0, 0.0);
    points->InsertNextPoint(NotFound, 0.0, 0.0);
    points->InsertNextPoint(0.0, 2.0 * Half, 0.0);
    points->InsertNextPoint(500.0, 0.0, 0.0);
    points->InsertNextPoint(0.0, 500.0, 0.0);
    const vtkIdType ids[5] = { 0, 1, 2, 3, 4 };
    input->SetPoints(points);
    input->AllocateExact(6, 20);
    input->InsertNextCell(VTK_VERTEX, 1, ids);
    input->InsertNextCell(VTK_POLY_VERTEX, 3, ids);
    input->InsertNextCell(VTK_VERTEX, 1, ids + 1);
    input->InsertNextCell(VTK_POLY_LINE, 5, ids);
    input->InsertNextCell(VTK_POLYGON, 5, ids);
    clamp->SetInputData(input);
    clamp->Update();
    CHECK_EQUAL(output->GetNumberOfVerts(), 2);
    CHECK_EQUAL(output->GetNumberOfLines(), 1);
    CHECK_EQUAL(output->GetNumberOfPolys(), 0);
    // A polygon over the border and the hole.
    const vtkIdType square[4] = { 0, 1, 2, 3 };
    points->SetPoint(0, 0.0, 0.0, 0.0);
    points->SetPoint(1, 2.0 * Half, 0.0, 0.0);
    points->SetPoint(2, 2.0 * Half, 2.0 * Half, 0.0);
    points->SetPoint(3, 0.0, 2.0 * Half, 0.0);
    points->Modified();
    vtkNew<vtkPolyData> border;
    border->SetPoints(points);
    border->AllocateExact(1, 4);
    border->InsertNextCell(VTK_QUAD, 4, square);
    clamp->SetInputData(border);
    clamp->Update();
    const double hole = 10.0 * 21.0 * Spacing * Spacing; // of the right half
    CHECK_NEAR(MeasureArea(output)[1] / (Half * Half - hole), 1.0, isDrawn ? 0.02 : 1e-9);
  }
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainClamp> clamp;
  RelevoErrors errors(clamp);
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors pyramidErrors(pyramid);
  clamp->SetInputData(MakeRandomLines(3));
  const auto checkError = [&](const char* words)
  {
    CHECK_CASE(words);
    RelevoErrors executive(clamp->GetExecutive());
    clamp->Update();
    CHECK(errors.Said(words));
    CHECK_EQUAL(clamp->GetOutput()->GetNumberOfPoints(), 0);
  };
  checkError("SetMapper() or SetPyramid()");
  clamp->SetPyramid(pyramid);
  pyramid->SetFileName("/nowhere/terrain.tif");
  checkError("/nowhere/terrain.tif");
  RelevoRaster plain = MakeRaster();
  plain.CoordinateSystem = "";
  plain.Transform.clear();
  const std::string name = folders.File("TerrainClampPlain.tif");
  CHECK(plain.Write(name));
  pyramid->SetFileName(name.c_str());
  clamp->SetCoordinateTypeToGeographic();
  checkError("no coordinate system");
  clamp->SetCoordinateTypeToRaster();
  clamp->Update();
  CHECK(errors.Warned("left out") && errors.None());
  for (int type : { -1, 3 })
  {
    clamp->SetCoordinateType(type);
    CHECK(errors.Said("CoordinateType"));
  }
  clamp->SetMaximumError(0.0);
  CHECK(errors.Said("MaximumError"));
  clamp->SetOffset(NotFound);
  CHECK(errors.Said("Offset"));
  clamp->SetExaggeration(NotFound);
  CHECK(errors.Said("Exaggeration"));
}

// Inputs without points, with points that do not exist, and with positions far away.
void TestInvalid(RelevoCheck& check, const std::string& file)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(file.c_str());
  vtkNew<vtkTerrainClamp> clamp;
  RelevoErrors errors(clamp);
  clamp->SetPyramid(pyramid);
  clamp->SetInputData(vtkNew<vtkPolyData>());
  clamp->Update();
  CHECK_EQUAL(clamp->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> invalid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1e300, -1e300, 0.0);
  const vtkIdType ids[4] = { 0, 7, -3, 1 };
  invalid->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4, ids);
  cells->InsertNextCell(1, ids);
  invalid->SetVerts(cells);
  invalid->SetLines(cells);
  invalid->SetPolys(cells);
  for (int type : { vtkTerrainClamp::WORLD, vtkTerrainClamp::RASTER })
  {
    clamp->SetCoordinateType(type);
    clamp->SetInputData(invalid);
    clamp->Update();
    CHECK_EQUAL(clamp->GetOutput()->GetNumberOfCells(), type == vtkTerrainClamp::WORLD ? 2 : 0);
  }
  CHECK(errors.Warned("left out"));
}

void TestFirstFrame(RelevoCheck& check, const std::string& file)
{
  // Before the first frame, the output is flat. The first frame draws it on the terrain.
  ClampScene scene(file);
  RelevoErrors none(scene.Clamp);
  scene.Clamp->SetInputData(MakeRandomLines(3));
  scene.Clamp->Update();
  vtkPolyData* output = scene.Clamp->GetOutput();
  CHECK_EQUAL(output->GetNumberOfCells(), 6);
  CHECK_NEAR(output->GetBounds()[4], output->GetBounds()[5], 1e-9);
  scene.Look(0.0, -10.0, 3.0 * Half);
  scene.Window->Render();
  CHECK_LESS(output->GetBounds()[4] + 100.0, output->GetBounds()[5]);
  CHECK(none.None());
  scene.Mapper->SetPyramid(nullptr);
  RelevoErrors mapperErrors(scene.Mapper);
  scene.Clamp->Update();
  CHECK(mapperErrors.Said("SetPyramid()") && none.None());
  CHECK_EQUAL(output->GetNumberOfPoints(), 0);
}
}

int TestTerrainClamp(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const RelevoRaster raster = MakeRaster();
  const std::string file = folders.File("TerrainClamp.tif");
  if (!CHECK(raster.Write(file)))
  {
    return check.GetResult();
  }
  TestDrawn(check, file);
  TestOutline(check, file);
  TestPicture(check, file, folders);
  TestFullResolution(check, raster, file);
  TestAttributes(check, file);
  TestCoordinates(check, file);
  TestTransforms(check, folders);
  TestAntimeridian(check, folders);
  TestMissing(check, folders);
  TestLimit(check, file);
  TestErrors(check, folders);
  TestInvalid(check, file);
  TestFirstFrame(check, file);
  return check.GetResult();
}
