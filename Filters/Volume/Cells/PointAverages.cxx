// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/PointAverages.h"

#include "Cells/CellChecks.h"
#include "Cells/LeftOutCells.h"
#include "Cells/MergedCellPoints.h"
#include "Integral/FillValues.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
std::vector<vtkIdType> FindPlacesOfAll(const std::vector<MeshScalars>& meshes)
{
  std::vector<dvec3> points;
  for (const MeshScalars& mesh : meshes)
  {
    for (vtkIdType i = 0; i < mesh.Mesh->GetNumberOfPoints(); ++i)
    {
      dvec3 point;
      mesh.Mesh->GetPoint(i, &point.x);
      points.push_back(point);
    }
  }
  return FindPlaces(points);
}

// Sums of the tuples of cells at places.
class Sums
{
public:
  Sums(size_t numberOfPoints, int numberOfComponents)
    : Tuple(static_cast<size_t>(numberOfComponents))
    , Values(numberOfPoints * this->Tuple.size(), 0.0)
    , Counts(numberOfPoints, 0)
  {
  }

  // `places` are those of the mesh's points. Returns the cells without a value.
  std::vector<vtkIdType> Add(const MeshScalars& mesh, const vtkIdType* places)
  {
    std::vector<std::vector<double>> fillValues;
    for (int c = 0; c < static_cast<int>(this->Tuple.size()); ++c)
    {
      fillValues.push_back(FindFillValues(static_cast<size_t>(mesh.Array->GetNumberOfTuples()),
        [&](size_t i) { return mesh.Array->GetComponent(static_cast<vtkIdType>(i), c); }));
    }
    std::vector<vtkIdType> missing;
    CellDemands demands;
    demands.TakesAllTypes = true;
    demands.TakesInfinitePoints = true;
    const CellChecks checks = CheckCells(mesh.Mesh, demands);
    const LeftOutCells leftOut(mesh.Mesh);
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0; cell < mesh.Mesh->GetNumberOfCells(); ++cell)
    {
      if (checks.Uses[static_cast<size_t>(cell)] != CellUse::Solid)
      {
        continue;
      }
      mesh.Mesh->GetCellPoints(cell, points);
      mesh.Array->GetTuple(cell, this->Tuple.data());
      if (leftOut.IsHidden(cell, points))
      {
        continue;
      }
      if (!std::equal(this->Tuple.begin(), this->Tuple.end(), fillValues.begin(),
            [](double value, const auto& fill) { return !IsMissing(value, fill); }))
      {
        missing.push_back(cell);
        continue;
      }
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        this->AddTuple(static_cast<size_t>(places[points->GetId(i)]));
      }
    }
    return missing;
  }

  vtkSmartPointer<vtkDataArray> Make(const MeshScalars& mesh, const vtkIdType* places) const
  {
    // Bytes stay bytes, because they may be colours.
    vtkSmartPointer<vtkDataArray> array = vtkSmartPointer<vtkDoubleArray>::New();
    if (vtkUnsignedCharArray::SafeDownCast(mesh.Array))
    {
      array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    }
    const size_t components = this->Tuple.size();
    array->SetName(mesh.Array->GetName());
    array->SetNumberOfComponents(static_cast<int>(components));
    array->SetNumberOfTuples(mesh.Mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh.Mesh->GetNumberOfPoints(); ++i)
    {
      const auto place = static_cast<size_t>(places[i]);
      for (size_t c = 0; c < components; ++c)
      {
        const double value = this->Counts[place] > 0
          ? this->Values[place * components + c] / this->Counts[place]
          : std::numeric_limits<double>::quiet_NaN();
        array->SetComponent(i, static_cast<int>(c), value);
      }
    }
    return array;
  }

private:
  void AddTuple(size_t place)
  {
    ++this->Counts[place];
    for (size_t c = 0; c < this->Tuple.size(); ++c)
    {
      this->Values[place * this->Tuple.size() + c] += this->Tuple[c];
    }
  }

  std::vector<double> Tuple;
  std::vector<double> Values;
  std::vector<int> Counts;
};

// Hides cells in a copy of the mesh.
void HideCells(MeshScalars& mesh, const std::vector<vtkIdType>& cells)
{
  if (cells.empty())
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(mesh.Mesh->GetNumberOfCells());
  ghosts->Fill(0);
  vtkUnsignedCharArray* old = mesh.Mesh->GetCellGhostArray();
  for (vtkIdType i = 0; old && i < std::min(old->GetNumberOfTuples(), ghosts->GetNumberOfTuples());
       ++i)
  {
    ghosts->SetValue(i, old->GetValue(i));
  }
  for (const vtkIdType cell : cells)
  {
    ghosts->SetValue(cell, ghosts->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
  }
  mesh.Copy = vtkSmartPointer<vtkDataSet>::Take(mesh.Mesh->NewInstance());
  mesh.Copy->ShallowCopy(mesh.Mesh);
  mesh.Copy->GetCellData()->AddArray(ghosts);
  mesh.Mesh = mesh.Copy;
}
}

std::string AverageAtPoints(std::vector<MeshScalars>& meshes)
{
  if (meshes.empty() || !meshes.front().AreOfCells)
  {
    return "";
  }
  const char* name = meshes.front().Array->GetName();
  const std::vector<vtkIdType> places = FindPlacesOfAll(meshes);
  Sums sums(places.size(), meshes.front().Array->GetNumberOfComponents());
  std::vector<std::vector<vtkIdType>> missing;
  const vtkIdType* first = places.data();
  for (const MeshScalars& mesh : meshes)
  {
    missing.push_back(sums.Add(mesh, first));
    first += mesh.Mesh->GetNumberOfPoints();
  }
  first = places.data();
  size_t number = 0;
  for (MeshScalars& mesh : meshes)
  {
    mesh.Array = sums.Make(mesh, first);
    mesh.AreOfCells = false;
    first += mesh.Mesh->GetNumberOfPoints();
    const std::vector<vtkIdType>& cells = missing[static_cast<size_t>(&mesh - meshes.data())];
    HideCells(mesh, cells);
    number += cells.size();
  }
  return "Isosurfaces need point values, so the cell array" +
    (name ? " \"" + std::string(name) + "\"" : "") + " is averaged at the points." +
    (number == 0 ? ""
        : number == 1
        ? " 1 cell has a fill value, or a value that is not finite; it is transparent."
        : " " + std::to_string(number) +
          " cells have fill values, or values that are not finite; they are transparent.");
}
}
