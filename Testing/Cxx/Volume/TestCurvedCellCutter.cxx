// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCurvedCellCutter promises sections in the shape of curved cells, with the values of the cells
// at every point; for linear cells, the sections of vtkCutter.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkCurvedCellCutter.h"
#include "vtkCutter.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkQuadraticHexahedron.h"
#include "vtkSphere.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
vtkSmartPointer<vtkPlane> MakePlane(
  const std::array<double, 3>& origin, const std::array<double, 3>& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  return plane;
}

// The sum of the polygons' area vectors.
std::array<double, 3> GetArea(vtkPolyData* mesh)
{
  std::array<double, 3> sum{};
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double normal[3];
    const double area =
      vtkPolygon::ComputeArea(mesh->GetPoints(), ids->GetNumberOfIds(), ids->GetPointer(0), normal);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += area * normal[c];
    }
  }
  return sum;
}

double GetLength(vtkPolyData* lines)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    sum += std::sqrt(lines->GetCell(cell)->GetLength2());
  }
  return sum;
}

// The mean of the points.
std::array<double, 3> GetMean(vtkDataSet* data)
{
  std::array<double, 3> sum{};
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += data->GetPoint(i)[c] / data->GetNumberOfPoints();
    }
  }
  return sum;
}

// Adds an array of a function of the coordinates of the nodes.
template <typename Function>
void AddArray(vtkUnstructuredGrid* grid, const char* name, const Function& function)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(function(grid->GetPoint(i)));
  }
  grid->GetPointData()->AddArray(array);
}

double GetLinear(const double* x)
{
  return x[0] + 2.0 * x[1] - x[2];
}

// The largest difference of an array from a function of the points.
template <typename Function>
double GetError(vtkPolyData* mesh, const char* name, const Function& function)
{
  double largest = 0.0;
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    largest = std::max(largest, std::abs(array->GetComponent(i, 0) - function(mesh->GetPoint(i))));
  }
  return largest;
}

// The location and value for parameters, by VTK's shape functions.
std::array<double, 4> Evaluate(vtkGenericCell* cell, vtkDataArray* values, const double* parameters)
{
  std::vector<double> weights(cell->GetNumberOfPoints());
  cell->InterpolateFunctions(parameters, weights.data());
  std::array<double, 4> sum{};
  for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
  {
    const double* point = cell->GetPoints()->GetPoint(k);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += weights[k] * point[c];
    }
    sum[3] += weights[k] * values->GetComponent(cell->GetPointId(k), 1);
  }
  return sum;
}

// The value at a point, with Newton's method and differences.
double FindValue(vtkGenericCell* cell, vtkDataArray* values, const double* point)
{
  const double step = 1e-6;
  double at[3] = { 0.3, 0.3, 0.6 }; // inside of all shapes
  for (int i = 0; i < 12; ++i)
  {
    const std::array<double, 4> here = Evaluate(cell, values, at);
    double matrix[3][3];
    double miss[3];
    for (int d = 0; d < 3; ++d)
    {
      double beside[3] = { at[0], at[1], at[2] };
      beside[d] += step;
      const std::array<double, 4> there = Evaluate(cell, values, beside);
      for (int c = 0; c < 3; ++c)
      {
        matrix[c][d] = (there[c] - here[c]) / step;
      }
      miss[d] = point[d] - here[d];
    }
    double move[3];
    vtkMath::LinearSolve3x3(matrix, miss, move);
    for (int c = 0; c < 3; ++c)
    {
      at[c] = std::min(std::max(at[c] + move[c], -0.1), 1.1); // not far outside
    }
  }
  return Evaluate(cell, values, at)[3];
}

// The largest difference of "Values" from the values by VTK's shape functions.
double GetValueError(vtkUnstructuredGrid* grid, vtkPolyData* section)
{
  vtkDataArray* values = section->GetPointData()->GetArray("Values");
  vtkDataArray* given = grid->GetPointData()->GetArray("Values");
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(0, cell);
  double largest = 0.0;
  for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
  {
    double point[3];
    section->GetPoint(i, point);
    largest =
      std::max(largest, std::abs(FindValue(cell, given, point) - values->GetComponent(i, 1)));
  }
  return largest;
}

// Every point is on the plane and has the values of the cell there.
void TestCell(RelevoCheck& check, vtkUnstructuredGrid* grid)
{
  CHECK_CASE(grid->GetCellType(0));
  CHECK_CASE(grid->GetNumberOfPoints());
  AddArray(grid, "Linear", GetLinear);
  const auto plane = MakePlane(GetMean(grid), { { 0.48, 0.6, 0.64 } });
  vtkNew<vtkCurvedCellCutter> cutter;
  RelevoErrors errors(cutter);
  cutter->SetInputData(grid);
  cutter->SetCutFunction(plane);
  cutter->SetTolerance(1e-2);
  cutter->SetFieldTolerance(0.2);
  cutter->Update();
  CHECK(errors.None());
  vtkPolyData* section = cutter->GetOutput();
  CHECK_GREATER(section->GetNumberOfPolys(), 0);
  CHECK_GREATER(cutter->GetLines()->GetNumberOfLines(), 2);
  double farthest = 0.0;
  for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
  {
    farthest = std::max(farthest, std::abs(plane->EvaluateFunction(section->GetPoint(i))));
  }
  CHECK_LESS(farthest, 1e-9);
  CHECK_LESS(GetError(section, "Linear", GetLinear), 1e-9);
  const int type = grid->GetCellType(0);
  // Derivatives of VTK_TRIQUADRATIC_PYRAMID are singular in VTK's parameters.
  const bool isQuadratic = type > VTK_HEXAGONAL_PRISM && type < VTK_TRIQUADRATIC_PYRAMID;
  CHECK_LESS(isQuadratic ? GetValueError(grid, section) : 0.0, 1e-7);
}

// A cell of degree p in x has the values of x to the power of p.
void TestPower(RelevoCheck& check, vtkUnstructuredGrid* grid, int degree)
{
  CHECK_CASE(grid->GetCellType(0));
  CHECK_CASE(degree);
  const double* box = grid->GetBounds();
  const double low = box[0];
  const double size = box[1] - box[0];
  const auto power = [&](const double* x) { return std::pow((x[0] - low) / size, degree); };
  AddArray(grid, "Power", power);
  vtkNew<vtkCurvedCellCutter> cutter;
  cutter->SetInputData(grid);
  cutter->SetCutFunction(MakePlane(GetMean(grid), { { 0.48, 0.6, 0.64 } }));
  cutter->Update();
  CHECK_GREATER(cutter->GetOutput()->GetNumberOfPolys(), 0);
  CHECK_LESS(GetError(cutter->GetOutput(), "Power", power), 1e-9);
}

void TestCells(RelevoCheck& check)
{
  for (int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_VOXEL,
         VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON,
         VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_HEXAHEDRON,
         VTK_QUADRATIC_LINEAR_WEDGE, VTK_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
         VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_PYRAMID })
  {
    const bool isLinear = type <= VTK_HEXAGONAL_PRISM;
    TestCell(check, RelevoNewCell(type, { 2, 2, 2 }, isLinear ? 0.0 : 0.1));
  }
  for (int p : { 1, 2, 3, 5 })
  {
    const int q = (3 * p) % 4 + 1;
    for (int first : { VTK_LAGRANGE_CURVE, VTK_BEZIER_CURVE })
    {
      if (p > 3 && first == VTK_BEZIER_CURVE)
      {
        continue; // VTK takes long for their shape functions
      }
      const bool isRational = first == VTK_BEZIER_CURVE;
      const double share = 0.2 / p;
      TestCell(check, RelevoNewCell(first + 3, { p, p, p }, share, isRational));
      TestCell(check, RelevoNewCell(first + 4, { p, q, 2 }, share, isRational));
      TestCell(check, RelevoNewCell(first + 5, { p, p, q }, share, isRational));
    }
    TestPower(check, RelevoNewCell(VTK_LAGRANGE_TETRAHEDRON, { p, p, p }, 0.0), p);
    TestPower(check, RelevoNewCell(VTK_LAGRANGE_HEXAHEDRON, { p, q, 2 }, 0.0), p);
    TestPower(check, RelevoNewCell(VTK_LAGRANGE_WEDGE, { p, p, q }, 0.0), p);
  }
}

// A quadratic hexahedron, bent so that z grows by x (1 - x) Bend. The array "Square" is x squared.
constexpr double Bend = 1.6;

vtkSmartPointer<vtkUnstructuredGrid> MakeArch()
{
  vtkNew<vtkQuadraticHexahedron> cell;
  const double* nodes = cell->GetParametricCoords();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> square;
  square->SetName("Square");
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 20; ++i)
  {
    const double x = nodes[3 * i];
    ids->InsertNextId(
      points->InsertNextPoint(x, nodes[3 * i + 1], nodes[3 * i + 2] + Bend * x * (1.0 - x)));
    square->InsertNextValue(x * x);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, ids);
  grid->GetPointData()->AddArray(square);
  return grid;
}

void TestShape(RelevoCheck& check)
{
  const auto arch = MakeArch();
  for (double tolerance : { 1e-2, 1e-3, 1e-4 })
  {
    CHECK_CASE(tolerance);
    vtkNew<vtkCurvedCellCutter> cutter;
    cutter->SetInputData(arch);
    cutter->SetCutFunction(MakePlane({ { 0.0, 0.3, 0.0 } }, { { 0.0, 1.0, 0.0 } }));
    cutter->SetTolerance(tolerance);
    cutter->Update();
    vtkPolyData* section = cutter->GetOutput();
    const double length = tolerance * arch->GetLength();
    const std::array<double, 3> area = GetArea(section);
    CHECK_NEAR(area[0], 0.0, 1e-12);
    CHECK_NEAR(area[1], -1.0, length); // counter-clockwise from the negative side
    CHECK_NEAR(area[2], 0.0, 1e-12);
    vtkDataArray* square = section->GetPointData()->GetArray("Square");
    double largest = 0.0;
    for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
    {
      const double x = section->GetPoint(i)[0];
      largest = std::max(largest, std::abs(square->GetComponent(i, 0) - x * x));
    }
    CHECK_LESS(largest, 1e-12);

    // The middles of the chords, which are farthest from the outline.
    vtkPolyData* lines = cutter->GetLines();
    double farthest = 0.0;
    for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
    {
      const double* box = lines->GetCell(i)->GetBounds();
      if (box[1] - box[0] < 1e-9)
      {
        continue; // the vertical sides
      }
      double ends[2][3];
      lines->GetPoint(lines->GetCell(i)->GetPointId(0), ends[0]);
      lines->GetPoint(lines->GetCell(i)->GetPointId(1), ends[1]);
      const double x = 0.5 * (ends[0][0] + ends[1][0]);
      const double z = 0.5 * (ends[0][2] + ends[1][2]) - Bend * x * (1.0 - x);
      farthest = std::max(farthest, std::min(std::abs(z), std::abs(z - 1.0)));
    }
    CHECK_GREATER(farthest, 0.0);
    CHECK_LESS(farthest, length);
  }
}

// A field that is curved in a cell with a straight shape is close to the cell's at the middles of
// the polygons, too.
void TestField(RelevoCheck& check)
{
  const auto square = [](const double* x) { return x[0] * x[0] - x[0] + x[1]; };
  for (double tolerance : { 0.5, 4e-3, 1e-3 })
  {
    CHECK_CASE(tolerance);
    const auto grid = RelevoNewCell(VTK_QUADRATIC_HEXAHEDRON, { 2, 2, 2 }, 0.0);
    AddArray(grid, "Square", square);
    vtkNew<vtkCurvedCellCutter> cutter;
    cutter->SetInputData(grid);
    cutter->SetCutFunction(MakePlane(GetMean(grid), { { 0.3, 0.1, 1.0 } }));
    cutter->SetFieldTolerance(tolerance);
    cutter->Update();
    vtkPolyData* section = cutter->GetOutput();
    vtkDataArray* values = section->GetPointData()->GetArray("Square");
    double largest = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < section->GetNumberOfCells(); ++i)
    {
      section->GetCellPoints(i, ids);
      double middle[3] = { 0.0, 0.0, 0.0 };
      double mean = 0.0;
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        const double share = 1.0 / ids->GetNumberOfIds();
        for (int c = 0; c < 3; ++c)
        {
          middle[c] += share * section->GetPoint(ids->GetId(k))[c];
        }
        mean += share * values->GetComponent(ids->GetId(k), 0);
      }
      largest = std::max(largest, std::abs(mean - square(middle)));
    }
    double range[2];
    grid->GetPointData()->GetArray("Square")->GetRange(range);
    CHECK_LESS(largest, tolerance * (range[1] - range[0]));
    CHECK_GREATER(largest, 0.0);
  }
}

// A quarter of a pipe as a rational Bézier cell: its section is between two circles.
void TestRational(RelevoCheck& check)
{
  const int corners[8][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 2, 0, 1 }, { 2, 1, 1 }, { 0, 1, 1 } };
  const int middles[4][3] = { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 1, 1, 1 } };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  vtkNew<vtkIdList> ids;
  const auto add = [&](const int* node)
  {
    const double radius = 1.0 + node[1];
    ids->InsertNextId(
      points->InsertNextPoint(node[0] < 2 ? radius : 0.0, node[0] > 0 ? radius : 0.0, node[2]));
    weights->InsertNextValue(node[0] == 1 ? std::sqrt(0.5) : 1.0);
  };
  for (const auto& node : corners)
  {
    add(node);
  }
  for (const auto& node : middles)
  {
    add(node);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_BEZIER_HEXAHEDRON, ids);
  grid->GetPointData()->SetRationalWeights(weights);
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(2, 1, 1);
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  vtkNew<vtkCurvedCellCutter> cutter;
  cutter->SetInputData(grid);
  cutter->SetCutFunction(MakePlane({ { 0.0, 0.0, 0.4 } }, { { 0.0, 0.0, 1.0 } }));
  cutter->Update();
  CHECK_NEAR(GetArea(cutter->GetOutput())[2], -0.75 * vtkMath::Pi(), 1e-3);
  vtkPolyData* lines = cutter->GetLines();
  CHECK_GREATER(lines->GetNumberOfLines(), 8);
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    double a[3];
    double b[3];
    lines->GetPoint(lines->GetCell(i)->GetPointId(0), a);
    lines->GetPoint(lines->GetCell(i)->GetPointId(1), b);
    const bool isStraight = a[0] * b[1] == a[1] * b[0]; // along a radius
    const double radius = std::hypot(a[0], a[1]);
    CHECK(isStraight || std::abs(radius - std::round(radius)) < 1e-12);
  }
}

vtkSmartPointer<vtkUnstructuredGrid> MakeBlocks(int type)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(3, 4, 5);
  source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

// vtkCutter has the same area, and the values are the same linear functions.
void TestLinear(RelevoCheck& check)
{
  for (int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_PENTAGONAL_PRISM,
         VTK_HEXAGONAL_PRISM })
  {
    CHECK_CASE(type);
    const auto grid = MakeBlocks(type);
    const auto plane = MakePlane({ { 1.4, 2.1, 2.3 } }, { { 0.48, 0.6, 0.64 } });
    vtkNew<vtkCurvedCellCutter> cutter;
    cutter->SetInputData(grid);
    cutter->SetCutFunction(plane);
    cutter->Update();
    vtkNew<vtkCutter> reference;
    reference->SetInputData(grid);
    reference->SetCutFunction(plane);
    reference->Update();
    vtkNew<vtkTriangleFilter> triangles; // vtkPolygon::ComputeArea() wants no degenerate polygons
    triangles->SetInputConnection(reference->GetOutputPort());
    triangles->Update();
    double expected = 0.0;
    for (vtkIdType i = 0; i < triangles->GetOutput()->GetNumberOfCells(); ++i)
    {
      double x[3][3];
      for (int k = 0; k < 3; ++k)
      {
        triangles->GetOutput()->GetPoint(triangles->GetOutput()->GetCell(i)->GetPointId(k), x[k]);
      }
      double a[3];
      double b[3];
      double c[3];
      vtkMath::Subtract(x[1], x[0], a);
      vtkMath::Subtract(x[2], x[0], b);
      vtkMath::Cross(a, b, c);
      expected += 0.5 * vtkMath::Norm(c);
    }
    const std::array<double, 3> area = GetArea(cutter->GetOutput());
    CHECK_NEAR(vtkMath::Norm(area.data()), expected, 1e-6 * expected);
    CHECK_LESS(area[0], 0.0);
    CHECK_EQUAL(
      cutter->GetOutput()->GetCellData()->GetArray("vtkOriginalCellIds") != nullptr, true);
  }
}

// One polygon per cell, with points and lines that neighbours share.
void TestNeighbours(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("Cell");
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(static_cast<double>(i));
  }
  image->GetCellData()->AddArray(ids);
  vtkNew<vtkCurvedCellCutter> cutter;
  cutter->SetInputData(image);
  const auto plane = MakePlane({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, 1.0 } });
  cutter->SetCutFunction(plane);
  cutter->Update();
  CHECK_EQUAL(cutter->GetOutput()->GetNumberOfPolys(), 12);
  CHECK_EQUAL(cutter->GetOutput()->GetNumberOfPoints(), 20);
  CHECK_EQUAL(cutter->GetLines()->GetNumberOfLines(), 31);
  CHECK_NEAR(GetLength(cutter->GetLines()), 31.0, 1e-12);
  CHECK_EQUAL(cutter->GetOutput()->GetCellData()->GetArray("Cell")->GetComponent(7, 0), 7.0);

  // A plane through a layer of points gives it once.
  plane->SetOrigin(0.0, 0.0, 1.0);
  cutter->Update();
  CHECK_EQUAL(cutter->GetOutput()->GetNumberOfPolys(), 12);
  CHECK_NEAR(GetArea(cutter->GetOutput())[2], -12.0, 1e-12);
  // Nothing is on the negative side of the first layer.
  plane->SetOrigin(0.0, 0.0, 0.0);
  cutter->Update();
  CHECK_EQUAL(cutter->GetOutput()->GetNumberOfPolys(), 0);
}

// Cells without common points keep their own values.
void TestDiscontinuous(RelevoCheck& check)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (int cell = 0; cell < 2; ++cell)
  {
    vtkNew<vtkIdList> ids;
    for (int k = 0; k < 8; ++k)
    {
      const int x = k % 4 == 1 || k % 4 == 2;
      ids->InsertNextId(points->InsertNextPoint(cell + x, k % 4 >= 2, k / 4));
      values->InsertNextValue(10.0 * cell + x);
    }
    grid->InsertNextCell(VTK_HEXAHEDRON, ids);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
  vtkNew<vtkCurvedCellCutter> cutter;
  cutter->SetInputData(grid);
  cutter->SetCutFunction(MakePlane({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, 1.0 } }));
  cutter->Update();
  vtkPolyData* section = cutter->GetOutput();
  CHECK_EQUAL(section->GetNumberOfPoints(), 8);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    vtkNew<vtkIdList> ids;
    section->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType id = ids->GetId(k);
      CHECK_NEAR(section->GetPointData()->GetScalars()->GetComponent(id, 0),
        9.0 * cell + section->GetPoint(id)[0], 1e-12);
    }
  }
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkCurvedCellCutter> cutter;
  RelevoErrors errors(cutter);
  cutter->SetInputData(MakeArch());
  cutter->Update();
  CHECK(errors.Said("SetCutFunction"));
  CHECK_EQUAL(cutter->GetOutput()->GetNumberOfPoints(), 0);

  // Points that are not finite, then no cells.
  vtkNew<vtkSphere> sphere;
  cutter->SetCutFunction(sphere);
  const auto bad = MakeArch();
  bad->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
  cutter->SetInputData(bad);
  cutter->Update();
  CHECK(errors.Said("Cell 0"));
  CHECK_EQUAL(cutter->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkUnstructuredGrid> empty;
  cutter->SetInputData(empty);
  cutter->Update();
  CHECK(errors.None());

  // Another function than a plane.
  sphere->SetCenter(0.0, 0.0, 0.0);
  sphere->SetRadius(0.5);
  cutter->SetInputData(MakeArch());
  cutter->Update();
  CHECK_GREATER(cutter->GetOutput()->GetNumberOfPolys(), 0);
  for (vtkIdType i = 0; i < cutter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    CHECK_NEAR(vtkMath::Norm(cutter->GetOutput()->GetPoint(i)), 0.5, 1e-9);
  }
  cutter->SetTolerance(0.0);
  CHECK(errors.Said("Tolerance"));
  CHECK_EQUAL(cutter->GetTolerance(), 1e-4);
}
}

int TestCurvedCellCutter(int, char*[])
{
  RelevoCheck check;
  TestCells(check);
  TestShape(check);
  TestField(check);
  TestRational(check);
  TestLinear(check);
  TestNeighbours(check);
  TestDiscontinuous(check);
  TestErrors(check);
  return check.GetResult();
}
