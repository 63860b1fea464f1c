// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatches.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>

namespace
{
double GetBinomial(int n, int k)
{
  double value = 1.0;
  for (int i = 0; i < k; ++i)
  {
    value = value * (n - i) / (i + 1);
  }
  return value;
}

std::array<vtkIdType, 4> GetRecord(vtkPolyData* mesh, int patch)
{
  std::array<vtkIdType, 4> record;
  vtkIdTypeArray::SafeDownCast(mesh->GetFieldData()->GetArray("Patches"))
    ->GetTypedTuple(patch, record.data());
  return record;
}

// Factors of the control points, without weights.
std::vector<double> GetFactors(const std::array<vtkIdType, 4>& record, double u, double v)
{
  const int p = static_cast<int>(record[1]);
  const int q = static_cast<int>(record[2]);
  std::vector<double> factors;
  if (record[0] == VTK_BEZIER_TRIANGLE)
  {
    for (int j = 0; j <= p; ++j)
    {
      for (int i = 0; i <= p - j; ++i)
      {
        factors.push_back(GetBinomial(p, i) * GetBinomial(p - i, j) * std::pow(u, i) *
          std::pow(v, j) * std::pow(1.0 - u - v, p - i - j));
      }
    }
    return factors;
  }
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      factors.push_back(GetBinomial(p, i) * std::pow(u, i) * std::pow(1.0 - u, p - i) *
        GetBinomial(q, j) * std::pow(v, j) * std::pow(1.0 - v, q - j));
    }
  }
  return factors;
}

using Places = std::vector<RelevoPosition>;

Places GetCorners(vtkPolyData* mesh, int patch)
{
  const std::array<vtkIdType, 4> record = GetRecord(mesh, patch);
  vtkDataArray* points = mesh->GetFieldData()->GetArray("PatchPoints");
  const bool isTriangle = RelevoIsTriangle(mesh, patch);
  Places corners;
  for (int k = 0; k < (isTriangle ? 3 : 4); ++k)
  {
    const bool atU = isTriangle ? k == 1 : k == 1 || k == 2;
    const std::vector<double> factors = GetFactors(record, atU, k >= 2);
    const auto corner = std::find(factors.begin(), factors.end(), 1.0) - factors.begin();
    RelevoPosition x;
    for (int c = 0; c < 3; ++c)
    {
      x[c] = points->GetComponent(record[3] + corner, c); // without rounding
    }
    corners.push_back(x);
  }
  return corners;
}

// Finds the parametric coordinates of these corners in the cell.
bool FindCorners(vtkCell* cell, const Places& corners, Places& parametric)
{
  parametric.clear();
  const double* coordinates = cell->GetParametricCoords(); // polygons have none
  for (const RelevoPosition& corner : corners)
  {
    for (vtkIdType node = 0; coordinates && node < cell->GetNumberOfPoints(); ++node)
    {
      RelevoPosition x;
      cell->GetPoints()->GetPoint(node, x.data());
      if (x == corner)
      {
        const double* at = coordinates + 3 * node;
        parametric.push_back({ at[0], at[1], at[2] });
        break;
      }
    }
  }
  return parametric.size() == corners.size();
}

// VTK's formula is singular for a pyramid, and for a prism it differs from that of its faces.
bool HasOwnFormula(int type)
{
  return type != VTK_PYRAMID && type != VTK_QUADRATIC_PYRAMID && type != VTK_TRIQUADRATIC_PYRAMID &&
    type != VTK_PENTAGONAL_PRISM && type != VTK_HEXAGONAL_PRISM;
}

// Returns the cell, its face, or `triangle`: whichever has a formula for a patch with these
// corners.
vtkCell* FindReference(
  vtkCell* cell, vtkTriangle* triangle, const Places& corners, Places& parametric)
{
  if (HasOwnFormula(cell->GetCellType()))
  {
    return FindCorners(cell, corners, parametric) ? cell : nullptr;
  }
  for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
  {
    if (FindCorners(cell->GetFace(face), corners, parametric))
    {
      return cell->GetFace(face);
    }
  }
  // One of several triangles of a face.
  triangle->Initialize();
  for (vtkIdType node = 0; node < cell->GetNumberOfPoints(); ++node)
  {
    RelevoPosition x;
    cell->GetPoints()->GetPoint(node, x.data());
    const auto corner = std::find(corners.begin(), corners.end(), x) - corners.begin();
    if (corner < 3)
    {
      triangle->PointIds->SetId(corner, cell->GetPointId(static_cast<int>(node)));
      triangle->Points->SetPoint(corner, x.data());
    }
  }
  return FindCorners(triangle, corners, parametric) ? triangle : nullptr;
}

RelevoPosition Mix(const Places& corners, double u, double v)
{
  const bool isTriangle = corners.size() == 3;
  const std::array<double, 4> shares = isTriangle
    ? std::array<double, 4>{ 1.0 - u - v, u, v, 0.0 }
    : std::array<double, 4>{ (1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v };
  RelevoPosition mean{ 0.0, 0.0, 0.0 };
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      mean[axis] += shares[k] * corners[k][axis];
    }
  }
  return mean;
}

// VTK's value at a point of the patch.
std::vector<double> GetReference(vtkUnstructuredGrid* grid, vtkCell* cell,
  const RelevoPosition& parametric, const std::string& name)
{
  int subId = 0;
  RelevoPosition x;
  std::vector<double> weights(cell->GetNumberOfPoints());
  cell->EvaluateLocation(subId, parametric.data(), x.data(), weights.data());
  if (name.empty())
  {
    return { x[0], x[1], x[2] };
  }
  vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
  std::vector<double> values(array->GetNumberOfComponents(), 0.0);
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    for (std::size_t node = 0; node < weights.size(); ++node)
    {
      values[c] += weights[node] * array->GetComponent(cell->GetPointId(static_cast<int>(node)), c);
    }
  }
  return values;
}
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoNewBracket(double bend)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> field;
  field->SetName("Field");
  field->SetNumberOfComponents(2);
  std::map<RelevoPosition, vtkIdType> known;
  const auto addPoint = [&](const RelevoPosition& x)
  {
    const auto [point, isNew] = known.insert({ x, points->GetNumberOfPoints() });
    if (isNew)
    {
      points->InsertNextPoint(x[0] + bend * std::sin(1.5 * x[1]),
        x[1] + bend * std::sin(1.5 * x[2]), x[2] + bend * std::sin(1.5 * x[0]));
      field->InsertNextTuple2(std::sin(x[0] + 2.0 * x[1]), x[2] * x[2]);
    }
    return point->second;
  };
  // Paths from one corner of a cube to the opposite one along three edges.
  constexpr int ways[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 1, 0, 2 },
    { 2, 1, 0 } };
  constexpr int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  grid->Allocate(18);
  for (const RelevoPosition& cube :
    { RelevoPosition{ 0, 0, 0 }, RelevoPosition{ 1, 0, 0 }, RelevoPosition{ 0, 0, 1 } })
  {
    for (int way = 0; way < 6; ++way)
    {
      std::array<RelevoPosition, 4> corners;
      corners.fill(cube);
      for (int step = 0; step < 3; ++step)
      {
        for (int later = step + 1; later < 4; ++later)
        {
          corners[later][ways[way][step]] += 1.0;
        }
      }
      if (way > 2)
      {
        std::swap(corners[1], corners[2]);
      }
      std::vector<vtkIdType> ids;
      for (const RelevoPosition& corner : corners)
      {
        ids.push_back(addPoint(corner));
      }
      for (const auto& edge : edges)
      {
        RelevoPosition middle;
        for (int c = 0; c < 3; ++c)
        {
          middle[c] = 0.5 * (corners[edge[0]][c] + corners[edge[1]][c]);
        }
        ids.push_back(addPoint(middle));
      }
      grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids.data());
    }
  }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(field);
  return grid;
}

vtkIdType RelevoGetNumberOfNodes(int type, const std::array<int, 3>& degrees)
{
  const vtkIdType x = degrees[0] + 1;
  switch (type)
  {
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return x * (x + 1) / 2;
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return x * (degrees[1] + 1);
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return x * (x + 1) * (x + 2) / 6;
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return x * (x + 1) / 2 * (degrees[2] + 1);
    default:
      return x * (degrees[1] + 1) * (degrees[2] + 1);
  }
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoNewCell(
  int type, const std::array<int, 3>& degrees, double share, bool isRational, vtkIdType nodes)
{
  vtkNew<vtkGenericCell> generic;
  generic->SetCellType(type);
  vtkIdType number = nodes ? nodes : generic->GetNumberOfPoints();
  const bool isOfAnyDegree = type >= VTK_LAGRANGE_CURVE;
  number = isOfAnyDegree && !nodes ? RelevoGetNumberOfNodes(type, degrees) : number;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(number);
  grid->SetPoints(points);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < number; ++i)
  {
    points->SetPoint(i, 0.0, 0.0, 0.0);
    ids.push_back(i);
  }
  grid->Allocate(1);
  grid->InsertNextCell(type, number, ids.data());
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  values->SetNumberOfComponents(2);
  std::mt19937 random(static_cast<unsigned int>(type));
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  for (vtkIdType i = 0; i < number; ++i)
  {
    weights->InsertNextValue(1.25 + noise(random));
    values->InsertNextTuple2(noise(random), noise(random));
  }
  grid->GetPointData()->AddArray(values);
  if (isRational)
  {
    grid->GetPointData()->SetRationalWeights(weights);
  }
  if (isOfAnyDegree)
  {
    vtkNew<vtkIntArray> orders;
    orders->SetName("HigherOrderDegrees");
    orders->SetNumberOfComponents(3);
    orders->InsertNextTuple3(degrees[0], degrees[1], degrees[2]);
    grid->GetCellData()->SetHigherOrderDegrees(orders);
  }
  const double* parametric = grid->GetCell(0)->GetParametricCoords();
  for (vtkIdType i = 0; i < number; ++i)
  {
    points->SetPoint(i, parametric[3 * i] + share * noise(random),
      parametric[3 * i + 1] + share * noise(random), parametric[3 * i + 2] + share * noise(random));
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> RelevoMakePatches(vtkUnstructuredGrid* grid, bool split)
{
  vtkNew<vtkPatchSurfaceFilter> filter;
  filter->SetSplitPatches(split);
  filter->SetInputData(grid);
  filter->Update();
  return filter->GetOutput();
}

int RelevoGetNumberOfPatches(vtkPolyData* mesh)
{
  return static_cast<int>(mesh->GetFieldData()->GetArray("Patches")->GetNumberOfTuples());
}

bool RelevoIsTriangle(vtkPolyData* mesh, int patch)
{
  return GetRecord(mesh, patch)[0] == VTK_BEZIER_TRIANGLE;
}

std::vector<double> RelevoEvaluatePatch(
  vtkPolyData* mesh, int patch, double u, double v, const std::string& name)
{
  const std::array<vtkIdType, 4> record = GetRecord(mesh, patch);
  vtkDataArray* points = mesh->GetFieldData()->GetArray("PatchPoints");
  vtkDataArray* array =
    name.empty() ? points : mesh->GetFieldData()->GetArray(("PatchNodes:" + name).c_str());
  std::vector<double> sums(name.empty() ? 3 : array->GetNumberOfComponents(), 0.0);
  double sum = 0.0;
  vtkIdType point = record[3];
  for (double factor : GetFactors(record, u, v))
  {
    const double share = factor * points->GetComponent(point, 3);
    sum += share;
    for (std::size_t c = 0; c < sums.size(); ++c)
    {
      sums[c] += share * array->GetComponent(point, static_cast<int>(c));
    }
    ++point;
  }
  for (double& value : sums)
  {
    value /= sum;
  }
  return sums;
}

double RelevoGetCellError(vtkUnstructuredGrid* grid, vtkPolyData* mesh, const std::string& name)
{
  constexpr int steps = 7;
  double error = 0.0;
  std::vector<int> tested(RelevoGetNumberOfPatches(mesh), 0);
  for (vtkIdType face = 0; face < mesh->GetNumberOfCells(); ++face)
  {
    const int patch =
      static_cast<int>(mesh->GetCellData()->GetArray("PatchIds")->GetComponent(face, 0));
    if (tested[patch]++)
    {
      continue;
    }
    const auto id = static_cast<vtkIdType>(
      mesh->GetCellData()->GetArray("vtkOriginalCellIds")->GetComponent(face, 0));
    Places parametric;
    vtkNew<vtkTriangle> triangle;
    vtkCell* cell = FindReference(grid->GetCell(id), triangle, GetCorners(mesh, patch), parametric);
    if (!cell)
    {
      return std::numeric_limits<double>::infinity();
    }
    for (int k = 0; k < (steps + 1) * (steps + 1); ++k)
    {
      const double u = k % (steps + 1) / static_cast<double>(steps);
      const double v = k / (steps + 1) / static_cast<double>(steps);
      if (RelevoIsTriangle(mesh, patch) && u + v > 1.0)
      {
        continue;
      }
      const std::vector<double> value = RelevoEvaluatePatch(mesh, patch, u, v, name);
      const std::vector<double> expected = GetReference(grid, cell, Mix(parametric, u, v), name);
      for (std::size_t c = 0; c < value.size(); ++c)
      {
        error = std::max(error, std::abs(value[c] - expected[c]));
      }
    }
  }
  return error;
}
