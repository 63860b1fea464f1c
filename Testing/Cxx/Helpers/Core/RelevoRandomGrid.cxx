// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRandomGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace RelevoFuzz
{
namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

struct FixedType
{
  int Type;
  int Dimension;
  int Points;
};

const std::vector<FixedType>& GetFixedTypes()
{
  static const std::vector<FixedType> types = { { VTK_VERTEX, 0, 1 }, { VTK_LINE, 1, 2 },
    { VTK_TRIANGLE, 2, 3 }, { VTK_PIXEL, 2, 4 }, { VTK_QUAD, 2, 4 }, { VTK_TETRA, 3, 4 },
    { VTK_VOXEL, 3, 8 }, { VTK_HEXAHEDRON, 3, 8 }, { VTK_WEDGE, 3, 6 }, { VTK_PYRAMID, 3, 5 },
    { VTK_PENTAGONAL_PRISM, 3, 10 }, { VTK_HEXAGONAL_PRISM, 3, 12 }, { VTK_QUADRATIC_EDGE, 1, 3 },
    { VTK_CUBIC_LINE, 1, 4 }, { VTK_QUADRATIC_TRIANGLE, 2, 6 }, { VTK_BIQUADRATIC_TRIANGLE, 2, 7 },
    { VTK_QUADRATIC_QUAD, 2, 8 }, { VTK_QUADRATIC_LINEAR_QUAD, 2, 6 },
    { VTK_BIQUADRATIC_QUAD, 2, 9 }, { VTK_QUADRATIC_TETRA, 3, 10 },
    { VTK_QUADRATIC_HEXAHEDRON, 3, 20 }, { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 3, 24 },
    { VTK_TRIQUADRATIC_HEXAHEDRON, 3, 27 }, { VTK_QUADRATIC_WEDGE, 3, 15 },
    { VTK_QUADRATIC_LINEAR_WEDGE, 3, 12 }, { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 3, 18 },
    { VTK_QUADRATIC_PYRAMID, 3, 13 }, { VTK_TRIQUADRATIC_PYRAMID, 3, 19 },
    { VTK_LAGRANGE_TRIANGLE, 2, 7 }, { VTK_LAGRANGE_TETRAHEDRON, 3, 15 } };
  return types;
}

// Types with at least this many points.
const std::vector<FixedType>& GetOpenTypes()
{
  static const std::vector<FixedType> types = { { VTK_POLY_VERTEX, 0, 1 }, { VTK_POLY_LINE, 1, 2 },
    { VTK_POLYGON, 2, 3 }, { VTK_TRIANGLE_STRIP, 2, 3 } };
  return types;
}

const std::vector<FixedType>& GetHigherOrderTypes()
{
  static const std::vector<FixedType> types = { { VTK_LAGRANGE_CURVE, 1, 0 },
    { VTK_LAGRANGE_TRIANGLE, 2, 0 }, { VTK_LAGRANGE_QUADRILATERAL, 2, 0 },
    { VTK_LAGRANGE_TETRAHEDRON, 3, 0 }, { VTK_LAGRANGE_HEXAHEDRON, 3, 0 },
    { VTK_LAGRANGE_WEDGE, 3, 0 }, { VTK_BEZIER_CURVE, 1, 0 }, { VTK_BEZIER_TRIANGLE, 2, 0 },
    { VTK_BEZIER_QUADRILATERAL, 2, 0 }, { VTK_BEZIER_TETRAHEDRON, 3, 0 },
    { VTK_BEZIER_HEXAHEDRON, 3, 0 }, { VTK_BEZIER_WEDGE, 3, 0 } };
  return types;
}

bool IsOfDegree(int type)
{
  return type >= VTK_LAGRANGE_CURVE && type <= VTK_BEZIER_PYRAMID;
}

// Whether the number of points does not determine the degrees.
bool NeedsDegrees(int type)
{
  return type == VTK_LAGRANGE_QUADRILATERAL || type == VTK_LAGRANGE_HEXAHEDRON ||
    type == VTK_LAGRANGE_WEDGE || type == VTK_BEZIER_QUADRILATERAL ||
    type == VTK_BEZIER_HEXAHEDRON || type == VTK_BEZIER_WEDGE;
}

int CountPoints(int type, const std::array<int, 3>& n)
{
  switch (type)
  {
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return n[0] + 1;
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return (n[0] + 1) * (n[0] + 2) / 2;
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return (n[0] + 1) * (n[1] + 1);
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return (n[0] + 1) * (n[0] + 2) * (n[0] + 3) / 6;
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return (n[0] + 1) * (n[0] + 2) / 2 * (n[2] + 1);
    default:
      return (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
  }
}
}

RandomGrid::RandomGrid(Dice& dice)
  : D(dice)
  , HasDegrees(dice.Once(2))
  , HasWeights(dice.Once(2))
{
  if (dice.Once(2))
  {
    this->Points->SetDataTypeToDouble();
  }
  const int number = 1 + dice.Throw(dice.Once(4) ? 200 : 30);
  for (int i = 0; i < number; ++i)
  {
    // Either on a lattice, so that points coincide and cells are flat or share faces, or anywhere.
    const auto place = [&] { return dice.Once(3) ? dice.Share() : 0.25 * dice.Throw(5); };
    this->Points->InsertNextPoint(place(), place(), place());
    this->Weights->InsertNextValue(0.5 + dice.Share());
  }
  this->Grid->SetPoints(this->Points);
  this->Grid->Allocate(8);
  this->Degrees->SetNumberOfComponents(3);
  const int size = dice.Throw(12);
  const bool spoilsCell = size > 0 && dice.Once(3);
  const int spoilt = spoilsCell ? dice.Throw(size) : -1;
  for (int i = 0; i < size; ++i)
  {
    if (dice.Once(8) && i != spoilt)
    {
      this->AddPolyhedron();
      continue;
    }
    Cell cell = this->MakeCell();
    if (i == spoilt)
    {
      this->SpoilCell(cell);
    }
    this->Insert(cell);
  }
  if (!spoilsCell && !this->Cells.empty() && dice.Once(3))
  {
    this->SpoilGrid();
  }
  this->AddArrays();
  this->Fence();
}

bool RandomGrid::HasDimension(int dimension) const
{
  return std::any_of(this->Cells.begin(), this->Cells.end(),
    [=](const Cell& cell) { return cell.Dimension == dimension; });
}

std::vector<vtkIdType> RandomGrid::ChoosePoints(int number)
{
  const auto all = static_cast<int>(this->Points->GetNumberOfPoints());
  std::vector<vtkIdType> points(static_cast<size_t>(number));
  for (vtkIdType& point : points)
  {
    point = this->D.Throw(all);
  }
  return points;
}

RandomGrid::Cell RandomGrid::MakeCell()
{
  const int kind = this->D.Throw(5);
  if (kind < 2)
  {
    const FixedType& type = this->D.Choose(GetFixedTypes());
    return { type.Type, type.Dimension, this->ChoosePoints(type.Points), { { 2.0, 2.0, 2.0 } } };
  }
  if (kind == 2)
  {
    const FixedType& type = this->D.Choose(GetOpenTypes());
    return { type.Type, type.Dimension, this->ChoosePoints(type.Points + this->D.Throw(6)),
      { { 0.0, 0.0, 0.0 } } };
  }
  const FixedType& type = this->D.Choose(GetHigherOrderTypes());
  std::array<int, 3> n;
  for (int& degree : n)
  {
    degree = 1 + this->D.Throw(this->D.Once(6) ? 8 : 3);
  }
  const bool isWedge = type.Type == VTK_LAGRANGE_WEDGE || type.Type == VTK_BEZIER_WEDGE;
  if (isWedge || !NeedsDegrees(type.Type))
  {
    n[1] = n[0];
    n[2] = isWedge ? n[2] : n[0];
  }
  // VTK's quadratic wedge has 21 nodes.
  if (isWedge && CountPoints(type.Type, n) == 21)
  {
    n = { { 1, 1, 1 } };
  }
  if (!this->HasDegrees && NeedsDegrees(type.Type))
  {
    n[1] = n[2] = n[0];
  }
  return { type.Type, type.Dimension, this->ChoosePoints(CountPoints(type.Type, n)),
    { { static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2]) } } };
}

// A tetrahedron with different points.
void RandomGrid::AddPolyhedron()
{
  const vtkIdType number = this->Points->GetNumberOfPoints();
  if (number < 4)
  {
    return;
  }
  const vtkIdType first = this->D.Throw(static_cast<int>(number) - 3);
  const vtkIdType ids[4] = { first, first + 1, first + 2, first + 3 };
  const vtkIdType faces[16] = { 3, ids[0], ids[2], ids[1], 3, ids[0], ids[1], ids[3], 3, ids[1],
    ids[2], ids[3], 3, ids[0], ids[3], ids[2] };
  this->Grid->InsertNextCell(VTK_POLYHEDRON, 4, ids, 4, faces);
  this->Degrees->InsertNextTuple3(0.0, 0.0, 0.0);
  this->Cells.push_back({ VTK_POLYHEDRON, 3, { ids, ids + 4 }, { { 0.0, 0.0, 0.0 } } });
}

void RandomGrid::Insert(const Cell& cell)
{
  if (cell.Type == VTK_POLYHEDRON)
  {
    return; // was added with its faces
  }
  this->Grid->InsertNextCell(
    cell.Type, static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  const bool isSimple = IsOfDegree(cell.Type) && !NeedsDegrees(cell.Type) && this->D.Once(2);
  this->Degrees->InsertNextTuple3(isSimple && this->Dimension < 0 ? 0.0 : cell.Degrees[0],
    isSimple && this->Dimension < 0 ? 0.0 : cell.Degrees[1],
    isSimple && this->Dimension < 0 ? 0.0 : cell.Degrees[2]);
  this->Cells.push_back(cell);
}

void RandomGrid::SpoilCell(Cell& cell)
{
  this->Dimension = cell.Dimension;
  const auto number = static_cast<vtkIdType>(this->Points->GetNumberOfPoints());
  const std::string name = " of a cell of type " + std::to_string(cell.Type);
  switch (this->D.Throw(6))
  {
    case 0:
    {
      const std::vector<vtkIdType> strange = { -1, number, number + 1000000, vtkIdType(1) << 40,
        std::numeric_limits<vtkIdType>::lowest() };
      cell.Points[static_cast<size_t>(this->D.Throw(static_cast<int>(cell.Points.size())))] =
        this->D.Choose(strange);
      this->Error = "a point that does not exist" + name;
      return;
    }
    case 1:
    {
      // Avoids numbers of points that fit another degree or a type of any size.
      const bool isOpen = cell.Type == VTK_POLY_VERTEX || cell.Type == VTK_POLY_LINE ||
        cell.Type == VTK_POLYGON || cell.Type == VTK_TRIANGLE_STRIP ||
        cell.Type == VTK_LAGRANGE_CURVE || cell.Type == VTK_BEZIER_CURVE;
      const int least = cell.Dimension == 2 ? 3 : cell.Dimension == 1 ? 2 : 1;
      const int other = cell.Points.size() == 5 ? 4 : (this->D.Once(2) ? 5 : 2);
      cell.Points = this->ChoosePoints(isOpen ? this->D.Throw(least) : other);
      const auto size = cell.Points.size();
      const bool fits = (cell.Type == VTK_LINE && size == 2) ||
        (size == 4 && cell.Dimension > 1 &&
          (cell.Type == VTK_TETRA || cell.Type == VTK_QUAD || cell.Type == VTK_PIXEL));
      if (fits)
      {
        cell.Points.push_back(0);
      }
      this->Error = "a wrong number of points" + name;
      return;
    }
    case 2:
    case 3:
      if (this->HasDegrees && IsOfDegree(cell.Type) && cell.Dimension > 1)
      {
        const std::vector<double> strange = { -1.0, 1e6, NaN, 9.0, 2.5, Infinity, -Infinity,
          1e300 };
        cell.Degrees[static_cast<size_t>(this->D.Throw(cell.Dimension))] = this->D.Choose(strange);
        if (NeedsDegrees(cell.Type) && this->D.Once(3))
        {
          cell.Degrees[0] = 0.0;
        }
        this->Error = "a degree" + name;
        return;
      }
      [[fallthrough]];
    case 4:
    {
      const std::vector<int> unknown = { 43, 50, 52, 66, VTK_LAGRANGE_PYRAMID, VTK_BEZIER_PYRAMID,
        120, 255 };
      cell.Type = this->D.Choose(unknown);
      this->Dimension = 4; // belongs to no dimension
      this->Error = "an unknown type";
      return;
    }
    default:
      this->Error = "a polyhedron";
      this->SpoilFaces();
      cell.Type = VTK_POLYHEDRON;
      cell.Dimension = 3;
      this->Dimension = 3;
  }
}

void RandomGrid::SpoilFaces()
{
  const vtkIdType number = this->Points->GetNumberOfPoints();
  std::vector<vtkIdType> ids(4);
  std::iota(ids.begin(), ids.end(), 0);
  for (vtkIdType& id : ids)
  {
    id = std::min(id, number - 1);
  }
  std::vector<vtkIdType> faces = { 3, ids[0], ids[2], ids[1], 3, ids[0], ids[1], ids[3], 3, ids[1],
    ids[2], ids[3], 3, ids[0], ids[3], ids[2] };
  vtkIdType size = 4;
  switch (this->D.Throw(4))
  {
    case 0:
      size = 0;
      faces.clear();
      this->Error += " without faces";
      break;
    case 1:
      faces[static_cast<size_t>(1 + this->D.Throw(3))] = this->D.Once(2) ? -1 : number + 5;
      this->Error += " with a face of a point that does not exist";
      break;
    case 2:
      faces = { 3, ids[0], ids[2], ids[1], 2, ids[0], ids[1] };
      size = 2;
      this->Error += " with a face of two points";
      break;
    default:
      faces[1] = number - 1;
      ids = { 0, 0, 0, 0 };
      this->IsSure = number > 1;
      this->Error += " with a face of a point that it does not list";
  }
  this->Grid->InsertNextCell(VTK_POLYHEDRON, 4, ids.data(), size, faces.data());
  this->Degrees->InsertNextTuple3(0.0, 0.0, 0.0);
  this->Cells.push_back({ VTK_POLYHEDRON, 3, ids, { { 0.0, 0.0, 0.0 } } });
}

void RandomGrid::SpoilGrid()
{
  switch (this->D.Throw(5))
  {
    case 0:
      this->SpoilPoint(false);
      return;
    case 1:
      this->SpoilPoint(true);
      return;
    case 2:
      if (this->HasDegrees)
      {
        const int most = static_cast<int>(this->Degrees->GetNumberOfTuples());
        const int left = this->D.Throw(most);
        this->Degrees->Resize(left);
        this->Error = "degrees for " + std::to_string(left) + " cells";
        this->IsSure = false;
        return;
      }
      [[fallthrough]];
    default:
      this->SpoilLists();
  }
}

void RandomGrid::SpoilPoint(bool isWeight)
{
  const Cell& cell = this->D.Choose(this->Cells);
  const bool isBezier = cell.Type >= VTK_BEZIER_CURVE && cell.Type <= VTK_BEZIER_PYRAMID;
  const vtkIdType point = this->D.Choose(cell.Points);
  this->IsPointError = true;
  this->Dimension = cell.Dimension;
  if (isWeight && this->HasWeights && isBezier)
  {
    const std::vector<double> strange = { 0.0, -1.0, NaN, Infinity };
    this->Weights->SetValue(point, this->D.Choose(strange));
    if (this->D.Once(4))
    {
      this->Weights->Resize(point);
    }
    this->IsPointError = false;
    this->IsSure = cell.Dimension > 1; // classes for surfaces and volumes ignore curves
    this->Error = "a weight of a cell of type " + std::to_string(cell.Type);
    return;
  }
  const std::vector<double> strange = { NaN, Infinity, -Infinity };
  double x[3] = { 0.0, 0.0, 0.0 };
  x[this->D.Throw(3)] = this->D.Choose(strange);
  this->Points->SetPoint(point, x);
  this->Error = "a point that is not finite of a cell of type " + std::to_string(cell.Type);
}

void RandomGrid::SpoilLists()
{
  const auto number = static_cast<int>(this->Cells.size());
  vtkDataArray* offsets = this->Grid->GetCells()->GetOffsetsArray();
  const vtkIdType size = this->Grid->GetCells()->GetConnectivityArray()->GetNumberOfTuples();
  const std::vector<double> strange = { -5.0, static_cast<double>(size) + 1.0, 1e12 };
  // VTK's SetCells() would take the points of polyhedra for faces.
  const bool hasPolyhedra = std::any_of(this->Cells.begin(), this->Cells.end(),
    [](const Cell& cell) { return cell.Type == VTK_POLYHEDRON; });
  if (this->D.Once(3) && !hasPolyhedra)
  {
    vtkNew<vtkUnsignedCharArray> types;
    const int left = this->D.Throw(number);
    for (int i = 0; i < left; ++i)
    {
      types->InsertNextValue(static_cast<unsigned char>(this->Grid->GetCellType(i)));
    }
    types->Squeeze();
    const vtkSmartPointer<vtkCellArray> cells = this->Grid->GetCells();
    this->Grid->SetCells(types, cells);
    this->Error = std::to_string(left) + " types for " + std::to_string(number) + " cells";
    return;
  }
  offsets->SetComponent(1 + this->D.Throw(number), 0, this->D.Choose(strange));
  this->Error = "an offset";
}

void RandomGrid::AddArrays()
{
  vtkNew<vtkFloatArray> field;
  field->SetName("field");
  vtkNew<vtkFloatArray> cellField;
  cellField->SetName("cells");
  for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
  {
    field->InsertNextValue(
      static_cast<float>(this->D.Once(20) ? this->D.Number() : this->D.Share()));
  }
  for (vtkIdType i = 0; i < this->Grid->GetNumberOfCells(); ++i)
  {
    cellField->InsertNextValue(static_cast<float>(this->D.Share()));
  }
  this->Grid->GetPointData()->SetScalars(field);
  this->Grid->GetCellData()->AddArray(cellField);
  if (this->HasDegrees)
  {
    this->Degrees->SetName("HigherOrderDegrees");
    this->Grid->GetCellData()->SetHigherOrderDegrees(this->Degrees);
  }
  if (this->HasWeights)
  {
    this->Weights->SetName("RationalWeights");
    this->Grid->GetPointData()->SetRationalWeights(this->Weights);
  }
}

void RandomGrid::Fence()
{
  for (vtkDataArray* array :
    { this->Points->GetData(), this->Grid->GetCells()->GetOffsetsArray(),
      this->Grid->GetCells()->GetConnectivityArray(), this->Grid->GetPointData()->GetArray("field"),
      static_cast<vtkDataArray*>(this->Degrees), static_cast<vtkDataArray*>(this->Weights) })
  {
    RelevoFuzz::Fence(array);
  }
}
}
