// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SimplifiedMesh.h"

#include "Boxes/BoxTree.h"
#include "Cells/CellSplitter.h"
#include "Cells/TetrahedronCrossing.h"
#include "Cells/VolumeCells.h"
#include "Mathematics/FiniteBox.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGridQuadricDecimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace relevo
{
namespace
{
constexpr double MinimumCells = 24.0;
// Relative to the side of a box. Points of the border may be slightly outside of the result.
constexpr float BoxMargin = 0.01f;

// The eight tetrahedra of a quadratic one.
constexpr int QuadraticParts[8][4] = { { 0, 4, 6, 7 }, { 4, 1, 5, 8 }, { 6, 5, 2, 9 },
  { 7, 8, 9, 3 }, { 4, 9, 5, 6 }, { 4, 9, 6, 7 }, { 4, 9, 7, 8 }, { 4, 9, 8, 5 } };

// Tetrahedra whose points are between -1 and 1, with scalars between 0 and 1, so that edges are
// collapsed by shape and scalars alike.
class TetrahedronMesh
{
public:
  explicit TetrahedronMesh(const VolumeCells& cells)
    : Cells(cells)
  {
    this->AddCells();
    this->MergePoints();
  }

  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid() const;
  // Restores positions and scalars of a grid.
  vtkSmartPointer<vtkUnstructuredGrid> Restore(vtkUnstructuredGrid* grid) const;
  size_t GetNumberOfCells() const { return this->Tetrahedra.size() / 4; }
  const std::vector<dvec3>& GetPoints() const { return this->Points; }
  const std::vector<double>& GetValues() const { return this->Values; }
  double GetScale() const { return this->Scale; }

private:
  void Add(const VolumeCells::Cell& cell, vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    for (const vtkIdType point : { a, b, c, d })
    {
      this->Tetrahedra.push_back(point);
      this->Scalars.push_back(cell.Scalars >= 0 ? this->Cells.GetCellScalars()[cell.Scalars][0]
                                                : this->Cells.GetPointScalars()[point][0]);
    }
  }
  void AddCells();
  void MergePoints();

  const VolumeCells& Cells;
  std::vector<vtkIdType> Tetrahedra; // four points each
  std::vector<double> Scalars;       // of these
  std::vector<dvec3> Points;
  std::vector<double> Values;
  dvec3 Center = dvec3(0.0);
  double Radius = 1.0;
  double Low = 0.0;
  double Scale = 1.0;
};

void TetrahedronMesh::AddCells()
{
  CellSplitter splitter;
  std::vector<vtkIdType> corners;
  for (const VolumeCells::Cell& cell : this->Cells.GetCells())
  {
    const int count = this->Cells.GetNumberOfCorners(cell);
    corners.clear();
    for (int i = 0; i < count; ++i)
    {
      corners.push_back(this->Cells.GetCornerId(cell, i));
    }
    if (count == 10)
    {
      for (const auto& part : QuadraticParts)
      {
        this->Add(cell, corners[part[0]], corners[part[1]], corners[part[2]], corners[part[3]]);
      }
      continue;
    }
    const int type = count == 8 ? VTK_HEXAHEDRON : count == 6 ? VTK_WEDGE : VTK_PYRAMID;
    const std::vector<vtkIdType>& split =
      count == 4 ? corners : splitter.Split(type, corners, this->Cells.GetPoints().data());
    for (size_t i = 0; i + 4 <= split.size(); i += 4)
    {
      this->Add(cell, split[i], split[i + 1], split[i + 2], split[i + 3]);
    }
  }
}

void TetrahedronMesh::MergePoints()
{
  const std::vector<dvec3>& given = this->Cells.GetPoints();
  std::vector<vtkIdType> order(given.size());
  std::iota(order.begin(), order.end(), vtkIdType(0));
  const auto key = [&](vtkIdType id) { return std::tie(given[id].x, given[id].y, given[id].z); };
  std::vector<char> isUsed(given.size(), 0);
  for (const vtkIdType point : this->Tetrahedra)
  {
    isUsed[point] = 1;
  }
  order.erase(std::remove_if(order.begin(), order.end(), [&](vtkIdType i) { return !isUsed[i]; }),
    order.end());
  std::sort(order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
  std::vector<vtkIdType> merged(given.size(), -1);
  FiniteBox box;
  for (size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || key(order[i - 1]) != key(order[i]))
    {
      this->Points.push_back(given[order[i]]);
      box.Add(&this->Points.back().x);
    }
    merged[order[i]] = static_cast<vtkIdType>(this->Points.size()) - 1;
  }
  std::vector<int> counts(this->Points.size(), 0);
  this->Values.assign(this->Points.size(), 0.0);
  for (size_t i = 0; i < this->Tetrahedra.size(); ++i)
  {
    this->Tetrahedra[i] = merged[this->Tetrahedra[i]];
    this->Values[this->Tetrahedra[i]] += this->Scalars[i];
    ++counts[this->Tetrahedra[i]];
  }
  this->Center = dvec3(box.GetMiddle(0), box.GetMiddle(1), box.GetMiddle(2));
  const double size = std::max({ box.GetSide(0), box.GetSide(1), box.GetSide(2) });
  this->Radius = size > 0.0 ? 0.5 * size : 1.0;
  for (size_t i = 0; i < this->Points.size(); ++i)
  {
    this->Points[i] = (this->Points[i] - this->Center) / this->Radius;
    this->Values[i] /= counts[i];
  }
  const auto range = std::minmax_element(this->Values.begin(), this->Values.end());
  if (range.first != this->Values.end() && *range.second > *range.first)
  {
    this->Low = *range.first;
    this->Scale = *range.second - *range.first;
  }
  for (double& value : this->Values)
  {
    value = (value - this->Low) / this->Scale;
  }
}

vtkSmartPointer<vtkUnstructuredGrid> TetrahedronMesh::MakeGrid() const
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("scalars");
  for (size_t i = 0; i < this->Points.size(); ++i)
  {
    points->InsertNextPoint(&this->Points[i].x);
    values->InsertNextValue(this->Values[i]);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
  grid->Allocate(static_cast<vtkIdType>(this->GetNumberOfCells()));
  for (size_t i = 0; i < this->Tetrahedra.size(); i += 4)
  {
    std::array<vtkIdType, 4> ids;
    std::copy(this->Tetrahedra.begin() + i, this->Tetrahedra.begin() + i + 4, ids.begin());
    const dvec3 origin = this->Points[ids[0]];
    const double volume = dot(this->Points[ids[3]] - origin,
      cross(this->Points[ids[1]] - origin, this->Points[ids[2]] - origin));
    if (volume < 0.0)
    {
      std::swap(ids[0], ids[1]);
    }
    if (volume != 0.0)
    {
      grid->InsertNextCell(VTK_TETRA, 4, ids.data());
    }
  }
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> TetrahedronMesh::Restore(vtkUnstructuredGrid* grid) const
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkDataArray* given = grid->GetPointData()->GetArray("scalars");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("scalars");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    dvec3 at;
    grid->GetPoint(i, &at.x);
    at = this->Center + this->Radius * at;
    points->InsertNextPoint(&at.x);
    // Collapsed edges may have values slightly out of the range.
    values->InsertNextValue(
      this->Low + this->Scale * std::clamp(given->GetComponent(i, 0), 0.0, 1.0));
  }
  result->SetPoints(points);
  result->SetCells(VTK_TETRA, grid->GetCells());
  result->GetPointData()->SetScalars(values);
  return result;
}

// Interpolates the scalars of tetrahedra.
class TetrahedronScalars
{
public:
  explicit TetrahedronScalars(vtkUnstructuredGrid* grid)
    : Grid(grid)
    , Scalars(grid->GetPointData()->GetArray("scalars"))
  {
    std::vector<FloatBox> boxes;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const TetrahedronCorners corners = this->GetCorners(cell, ids);
      FloatBox box;
      for (int c = 0; c < 3; ++c)
      {
        const auto range =
          std::minmax({ corners[0][c], corners[1][c], corners[2][c], corners[3][c] });
        const float margin = BoxMargin * static_cast<float>(range.second - range.first);
        box.Low[c] = static_cast<float>(range.first) - margin;
        box.High[c] = static_cast<float>(range.second) + margin;
      }
      boxes.push_back(box);
    }
    this->Tree.Build(boxes);
  }

  // Returns the scalar at a point, or the given one far outside of all tetrahedra.
  double Evaluate(const dvec3& point, double given)
  {
    double best = -BoxMargin;
    double value = given;
    double nearest = 1.0;
    const auto isOutside = [&](const FloatBox& box, double)
    {
      bool isIn = true;
      for (int c = 0; c < 3; ++c)
      {
        isIn = isIn && point[c] >= box.Low[c] && point[c] <= box.High[c];
      }
      return isIn ? 0.0 : 2.0;
    };
    this->Tree.Visit(nearest, isOutside,
      [&](int cell)
      {
        if (best >= 0.0)
        {
          return;
        }
        const TetrahedronCorners corners = this->GetCorners(cell, this->Ids);
        CornerSlopes slopes;
        ComputeSlopes(corners, slopes);
        const dvec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
        double least = 1.0;
        double sum = 0.0;
        for (int i = 0; i < 4; ++i)
        {
          const double weight = 0.25 + dot(slopes[i], point - middle);
          least = std::min(least, weight);
          sum += weight * this->Scalars->GetComponent(this->Ids->GetId(i), 0);
        }
        if (least > best)
        {
          best = least;
          value = sum;
        }
      });
    return value;
  }

private:
  TetrahedronCorners GetCorners(vtkIdType cell, vtkIdList* ids) const
  {
    this->Grid->GetCellPoints(cell, ids);
    TetrahedronCorners corners;
    for (int i = 0; i < 4; ++i)
    {
      this->Grid->GetPoint(ids->GetId(i), &corners[i].x);
    }
    return corners;
  }

  vtkUnstructuredGrid* Grid;
  vtkDataArray* Scalars;
  vtkNew<vtkIdList> Ids;
  FloatBoxTree Tree;
};
}

SimplifiedMesh SimplifiedMesh::Make(
  const VolumeCells& cells, double share, const std::atomic<bool>& isOutdated)
{
  SimplifiedMesh result;
  const TetrahedronMesh mesh(cells);
  const auto number = static_cast<double>(mesh.GetNumberOfCells());
  if (isOutdated || number < MinimumCells)
  {
    return result;
  }
  const auto grid = mesh.MakeGrid();
  vtkNew<vtkUnstructuredGridQuadricDecimation> decimation;
  decimation->SetInputData(grid);
  decimation->SetScalarsName("scalars");
  decimation->SetNumberOfTetsOutput(
    static_cast<int>(std::max(share * static_cast<double>(cells.GetCells().size()), MinimumCells)));
  decimation->Update();
  vtkUnstructuredGrid* simple = decimation->GetOutput();
  if (isOutdated || simple->GetNumberOfCells() == 0 || !simple->GetPointData()->GetArray("scalars"))
  {
    return result;
  }
  TetrahedronScalars scalars(simple);
  for (size_t i = 0; i < mesh.GetPoints().size() && !isOutdated; ++i)
  {
    const double given = mesh.GetValues()[i];
    result.Error =
      std::max(result.Error, std::abs(scalars.Evaluate(mesh.GetPoints()[i], given) - given));
  }
  result.Error *= mesh.GetScale();
  result.Mesh = mesh.Restore(simple);
  return result;
}
}
