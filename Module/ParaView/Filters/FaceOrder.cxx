// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceOrder.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>

namespace relevo
{
namespace
{
// Return a value that can be compared, also for NaN.
double GetNumber(vtkDataArray* array, vtkIdType id, int component)
{
  const double value = array->GetComponent(id, component);
  return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
}

// Return the ids 0 to n - 1, sorted stably by a comparison.
template <typename Less>
std::vector<vtkIdType> SortIds(vtkIdType n, const Less& less)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(n));
  std::iota(ids.begin(), ids.end(), 0);
  vtkSMPTools::Sort(ids.begin(), ids.end(),
    [&less](vtkIdType a, vtkIdType b) { return less(a, b) || (!less(b, a) && a < b); });
  return ids;
}

// Ids and ghost types of a process differ from those of others.
bool IsOfProcess(vtkDataArray* array)
{
  const char* name = array->GetName();
  return name &&
    (std::strcmp(name, "vtkOriginalPointIds") == 0 ||
      std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0);
}

// Compares points by coordinates, texture coordinates, normals and other arrays.
class PointOrder
{
public:
  explicit PointOrder(vtkPolyData* mesh)
  {
    vtkPointData* data = mesh->GetPointData();
    for (vtkDataArray* array :
      { mesh->GetPoints()->GetData(), data->GetTCoords(), data->GetNormals() })
    {
      this->Add(array);
    }
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      this->Add(array && !IsOfProcess(array) ? array : nullptr);
    }
  }

  bool IsLess(vtkIdType a, vtkIdType b) const
  {
    for (vtkDataArray* array : this->Arrays)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double ofA = GetNumber(array, a, c);
        const double ofB = GetNumber(array, b, c);
        if (ofA != ofB)
        {
          return ofA < ofB;
        }
      }
    }
    return false;
  }

private:
  void Add(vtkDataArray* array)
  {
    if (array && std::find(this->Arrays.begin(), this->Arrays.end(), array) == this->Arrays.end())
    {
      this->Arrays.push_back(array);
    }
  }

  std::vector<vtkDataArray*> Arrays;
};

// Return the ids of the points in the new order, without those that are merged. `newIds` gets the
// new id of each point.
std::vector<vtkIdType> SortPoints(
  vtkPolyData* mesh, vtkIdType numberOfOwnPoints, std::vector<vtkIdType>& newIds)
{
  const PointOrder points(mesh);
  const std::vector<vtkIdType> sorted = SortIds(
    mesh->GetNumberOfPoints(), [&points](vtkIdType a, vtkIdType b) { return points.IsLess(a, b); });
  std::vector<vtkIdType> order;
  newIds.resize(sorted.size());
  for (vtkIdType id : sorted)
  {
    // Of equal points, those of the process are the first.
    if (order.empty() || id < numberOfOwnPoints || points.IsLess(order.back(), id))
    {
      order.push_back(id);
    }
    newIds[static_cast<std::size_t>(id)] = static_cast<vtkIdType>(order.size()) - 1;
  }
  return order;
}

template <typename Attributes>
void Rearrange(Attributes* data, const std::vector<vtkIdType>& order)
{
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(static_cast<vtkIdType>(order.size()));
  std::copy(order.begin(), order.end(), ids->GetPointer(0));
  vtkNew<Attributes> sorted;
  sorted->CopyAllOn();
  sorted->CopyAllocate(data, ids->GetNumberOfIds());
  sorted->CopyData(data, ids, vtkIdType(0));
  data->ShallowCopy(sorted);
}

// The cells with the new ids of their points, sorted by these on request.
class RenumberedCells
{
public:
  RenumberedCells(vtkCellArray* cells, const std::vector<vtkIdType>& newIds)
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      iterator->GetCurrentCell(size, ids);
      std::transform(ids, ids + size, std::back_inserter(this->Points),
        [&newIds](vtkIdType id) { return newIds[static_cast<std::size_t>(id)]; });
      this->Starts.push_back(this->Points.size());
    }
    this->Order.resize(this->Starts.size() - 1);
    std::iota(this->Order.begin(), this->Order.end(), 0);
  }

  void Sort()
  {
    this->Order = SortIds(static_cast<vtkIdType>(this->Order.size()),
      [this](vtkIdType a, vtkIdType b)
      {
        return std::lexicographical_compare(
          this->At(a), this->At(a + 1), this->At(b), this->At(b + 1));
      });
  }

  vtkSmartPointer<vtkCellArray> GetCells() const
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->AllocateExact(
      static_cast<vtkIdType>(this->Order.size()), static_cast<vtkIdType>(this->Points.size()));
    for (vtkIdType cell : this->Order)
    {
      cells->InsertNextCell(this->At(cell + 1) - this->At(cell), this->At(cell));
    }
    return cells;
  }

  // Return the former id of each cell.
  const std::vector<vtkIdType>& GetOrder() const { return this->Order; }

private:
  const vtkIdType* At(vtkIdType cell) const
  {
    return this->Points.data() + this->Starts[static_cast<std::size_t>(cell)];
  }

  std::vector<vtkIdType> Points;
  std::vector<std::size_t> Starts{ 0 };
  std::vector<vtkIdType> Order;
};

void SortCells(vtkPolyData* mesh, const std::vector<vtkIdType>& newIds)
{
  RenumberedCells verts(mesh->GetVerts(), newIds);
  RenumberedCells lines(mesh->GetLines(), newIds);
  RenumberedCells polys(mesh->GetPolys(), newIds);
  RenumberedCells strips(mesh->GetStrips(), newIds);
  polys.Sort();
  std::vector<vtkIdType> order;
  vtkIdType first = 0;
  for (const RenumberedCells* cells : { &verts, &lines, &polys, &strips })
  {
    std::transform(cells->GetOrder().begin(), cells->GetOrder().end(), std::back_inserter(order),
      [first](vtkIdType cell) { return first + cell; });
    first = static_cast<vtkIdType>(order.size());
  }
  mesh->SetVerts(verts.GetCells());
  mesh->SetLines(lines.GetCells());
  mesh->SetPolys(polys.GetCells());
  mesh->SetStrips(strips.GetCells());
  Rearrange(mesh->GetCellData(), order);
}
}

void SortByPosition(vtkPolyData* mesh, vtkIdType numberOfOwnPoints)
{
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  std::vector<vtkIdType> newIds;
  const std::vector<vtkIdType> order = SortPoints(mesh, numberOfOwnPoints, newIds);
  const vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    points->GetData()->SetTuple(static_cast<vtkIdType>(i), order[i], mesh->GetPoints()->GetData());
  }
  SortCells(mesh, newIds);
  Rearrange(mesh->GetPointData(), order);
  mesh->SetPoints(points);
}

void SortByPosition(vtkPolyData* mesh)
{
  SortByPosition(mesh, mesh->GetNumberOfPoints());
}
}
