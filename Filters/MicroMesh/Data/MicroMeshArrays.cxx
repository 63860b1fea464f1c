// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MicroMeshArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace relevo
{
namespace
{
template <class Array>
vtkSmartPointer<Array> NewMicroArray(const char* name, int components, std::size_t tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

template <class Array>
vtkSmartPointer<vtkDataArray> CopySamples(const std::vector<std::int16_t>& samples)
{
  auto array = NewMicroArray<Array>(MicroDisplacementsName, 1, samples.size());
  std::transform(samples.begin(), samples.end(), array->GetPointer(0),
    [](std::int16_t sample) { return static_cast<typename Array::ValueType>(sample); });
  return array;
}

// Finds an array of a type; `tuples` is its size or -1 for any.
template <class Array>
Array* FindArray(
  vtkFieldData* data, const char* name, int components, vtkIdType tuples, std::string& error)
{
  auto array = Array::SafeDownCast(data->GetAbstractArray(name));
  if (!array)
  {
    error = std::string("the mesh is not a micro-mesh: it has no array \"") + name +
      "\" of the right type. Use vtkMicroMeshFilter";
    return nullptr;
  }
  if (array->GetNumberOfComponents() != components ||
    (tuples >= 0 && array->GetNumberOfTuples() != tuples))
  {
    error = std::string("the array \"") + name + "\" of the micro-mesh has the wrong size";
    return nullptr;
  }
  return array;
}

class MicroReader
{
public:
  MicroReader(vtkPolyData* mesh, MicroMesh& micro, std::string& error)
    : Mesh(mesh)
    , Micro(micro)
    , Error(error)
  {
  }

  bool ReadSamples()
  {
    vtkFieldData* fields = this->Mesh->GetFieldData();
    auto array = vtkDataArray::SafeDownCast(fields->GetAbstractArray(MicroDisplacementsName));
    if (!array || array->GetNumberOfComponents() != 1 ||
      (array->GetDataType() != VTK_SIGNED_CHAR && array->GetDataType() != VTK_SHORT))
    {
      this->Error = std::string("the mesh is not a micro-mesh: it has no array \"") +
        MicroDisplacementsName + "\" of signed char or short. Use vtkMicroMeshFilter";
      return false;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      this->Micro.Samples.push_back(static_cast<std::int16_t>(array->GetComponent(i, 0)));
    }
    return true;
  }

  bool ReadPoints()
  {
    const vtkIdType number = this->Mesh->GetNumberOfPoints();
    auto directions = FindArray<vtkFloatArray>(
      this->Mesh->GetPointData(), MicroDirectionsName, 3, number, this->Error);
    if (!directions)
    {
      return false;
    }
    for (vtkIdType i = 0; i < number; ++i)
    {
      double x[3];
      this->Mesh->GetPoint(i, x);
      this->Micro.Points.emplace_back(x[0], x[1], x[2]);
      const float* d = directions->GetPointer(3 * i);
      if (!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2]))
      {
        this->Error = std::string("the array \"") + MicroDirectionsName +
          "\" of the micro-mesh is not finite at point " + std::to_string(i);
        return false;
      }
      this->Micro.Directions.emplace_back(d[0], d[1], d[2]);
    }
    return true;
  }

  bool ReadEdges()
  {
    auto edges =
      FindArray<vtkIntArray>(this->Mesh->GetFieldData(), MicroEdgesName, 2, -1, this->Error);
    if (!edges)
    {
      return false;
    }
    for (vtkIdType i = 0; i < edges->GetNumberOfTuples(); ++i)
    {
      const int* edge = edges->GetPointer(2 * i);
      if (!this->HasLevel(edge[1]) || !this->HasSamples(edge[0], (1 << edge[1]) - 1))
      {
        this->Error = std::string("tuple ") + std::to_string(i) + " of the array \"" +
          MicroEdgesName + "\" of the micro-mesh is invalid";
        return false;
      }
      this->Micro.Edges.push_back({ edge[0], edge[1] });
    }
    return true;
  }

  bool ReadFaces()
  {
    vtkPolyData* mesh = this->Mesh;
    if (mesh->GetNumberOfPolys() != mesh->GetNumberOfCells())
    {
      this->Error = "the micro-mesh has cells other than triangles";
      return false;
    }
    auto faces = FindArray<vtkIntArray>(
      mesh->GetCellData(), MicroFacesName, 5, mesh->GetNumberOfCells(), this->Error);
    if (!faces)
    {
      return false;
    }
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      vtkIdType size;
      const vtkIdType* corners;
      mesh->GetPolys()->GetCellAtId(cell, size, corners);
      const int* numbers = faces->GetPointer(5 * cell);
      if (size != 3 || !this->IsFace(numbers))
      {
        this->Error = "cell " + std::to_string(cell) +
          (size != 3 ? std::string(" of the micro-mesh is not a triangle")
                     : std::string(" has invalid values in the array \"") + MicroFacesName + "\"");
        return false;
      }
      MicroMesh::Face face{};
      for (int c = 0; c < 3; ++c)
      {
        face.Corners[c] = static_cast<int>(corners[c]);
        face.Edges[c] = numbers[c];
      }
      face.FirstInner = numbers[3];
      face.Level = numbers[4];
      this->Micro.Faces.push_back(face);
    }
    return true;
  }

private:
  bool HasLevel(int level) const { return level >= 0 && level <= LargestMicroLevel; }
  bool HasSamples(int first, int number) const
  {
    return number == 0 ||
      (first >= 0 &&
        static_cast<std::size_t>(first) + static_cast<std::size_t>(number) <=
          this->Micro.Samples.size());
  }
  bool IsFace(const int numbers[5]) const
  {
    const int level = numbers[4];
    if (!this->HasLevel(level) ||
      !this->HasSamples(numbers[3], level > 0 ? GetNumberOfInnerPoints(1 << level) : 0))
    {
      return false;
    }
    return std::all_of(numbers, numbers + 3,
      [&](int reference)
      {
        return reference >= 0 &&
          static_cast<std::size_t>(reference >> 1) < this->Micro.Edges.size() &&
          this->Micro.Edges[static_cast<std::size_t>(reference >> 1)].Level <= level;
      });
  }

  vtkPolyData* Mesh;
  MicroMesh& Micro;
  std::string& Error;
};
}

void StoreMicroMesh(const MicroMesh& micro, vtkPolyData* mesh)
{
  auto directions = NewMicroArray<vtkFloatArray>(MicroDirectionsName, 3, micro.Directions.size());
  for (std::size_t i = 0; i < micro.Directions.size(); ++i)
  {
    directions->SetTypedTuple(static_cast<vtkIdType>(i), &micro.Directions[i].x);
  }
  auto faces = NewMicroArray<vtkIntArray>(MicroFacesName, 5, micro.Faces.size());
  for (std::size_t i = 0; i < micro.Faces.size(); ++i)
  {
    const MicroMesh::Face& face = micro.Faces[i];
    const int numbers[5] = { face.Edges[0], face.Edges[1], face.Edges[2], face.FirstInner,
      face.Level };
    faces->SetTypedTuple(static_cast<vtkIdType>(i), numbers);
  }
  auto edges = NewMicroArray<vtkIntArray>(MicroEdgesName, 2, micro.Edges.size());
  for (std::size_t i = 0; i < micro.Edges.size(); ++i)
  {
    const int numbers[2] = { micro.Edges[i].First, micro.Edges[i].Level };
    edges->SetTypedTuple(static_cast<vtkIdType>(i), numbers);
  }
  constexpr int most = std::numeric_limits<signed char>::max();
  const bool isSmall = std::all_of(micro.Samples.begin(), micro.Samples.end(),
    [](std::int16_t sample) { return std::abs(sample) <= most; });
  mesh->GetPointData()->AddArray(directions);
  mesh->GetCellData()->AddArray(faces);
  mesh->GetFieldData()->AddArray(edges);
  mesh->GetFieldData()->AddArray(isSmall ? CopySamples<vtkSignedCharArray>(micro.Samples)
                                         : CopySamples<vtkShortArray>(micro.Samples));
}

void StoreInputBounds(const double bounds[6], vtkPolyData* mesh)
{
  auto array = NewMicroArray<vtkDoubleArray>(MicroInputBoundsName, 1, 6);
  std::copy_n(bounds, 6, array->GetPointer(0));
  mesh->GetFieldData()->AddArray(array);
}

int FindFinestLevel(vtkPolyData* mesh)
{
  auto faces = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(MicroFacesName));
  if (!faces || faces->GetNumberOfComponents() != 5)
  {
    return LargestMicroLevel;
  }
  int finest = 0;
  for (vtkIdType f = 0; f < faces->GetNumberOfTuples(); ++f)
  {
    finest = std::max(finest, faces->GetTypedComponent(f, 4));
  }
  return std::min(finest, LargestMicroLevel);
}

bool TakeMicroMesh(vtkPolyData* mesh, MicroMesh& micro, std::string& error)
{
  MicroReader reader(mesh, micro, error);
  return reader.ReadSamples() && reader.ReadPoints() && reader.ReadEdges() && reader.ReadFaces();
}
}
