// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/PointAverages.h"

#include "Cells/CellChecks.h"
#include "Cells/LeftOutCells.h"
#include "Cells/MergedCellPoints.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
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

  // `places` are those of the mesh's points.
  void Add(const MeshScalars& mesh, const vtkIdType* places)
  {
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
      const bool isFinite = std::all_of(
        this->Tuple.begin(), this->Tuple.end(), [](double value) { return std::isfinite(value); });
      for (vtkIdType i = 0;
           isFinite && !leftOut.IsHidden(cell, points) && i < points->GetNumberOfIds(); ++i)
      {
        this->AddTuple(static_cast<size_t>(places[points->GetId(i)]));
      }
    }
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
  const vtkIdType* first = places.data();
  for (const MeshScalars& mesh : meshes)
  {
    sums.Add(mesh, first);
    first += mesh.Mesh->GetNumberOfPoints();
  }
  first = places.data();
  for (MeshScalars& mesh : meshes)
  {
    mesh.Array = sums.Make(mesh, first);
    mesh.AreOfCells = false;
    first += mesh.Mesh->GetNumberOfPoints();
  }
  return "Isosurfaces need point values, so the cell array" +
    (name ? " \"" + std::string(name) + "\"" : "") + " is averaged at the points.";
}
}
