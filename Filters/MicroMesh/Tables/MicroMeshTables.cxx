// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/MicroMeshTables.h"

#include "Data/MicroMeshArrays.h"
#include "Data/MicroNormals.h"
#include "Data/OctahedralUnit.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Packs a displacement and a normal; see unpacking in relevoMicroMesh.glsl.
int PackSample(std::int16_t displacement, const vec3& normal)
{
  const OctahedralUnit unit = ToOctahedral(dvec3(normal));
  // A normal without length is (0, 0, 1).
  const unsigned int x = unit == NoOctahedralUnit ? 127u : unit[0];
  const unsigned int y = unit == NoOctahedralUnit ? 127u : unit[1];
  const auto low = static_cast<unsigned int>(displacement + 32768);
  return static_cast<int>(low | x << 16 | y << 24);
}

// The lowest and highest sample of a face, and 0.
std::array<int, 2> FindRange(const MicroMesh& mesh, const MicroMesh::Face& face)
{
  std::array<int, 2> range{ { 0, 0 } };
  const auto add = [&](int first, int number)
  {
    for (int i = first; i < first + number; ++i)
    {
      const int sample = mesh.Samples[static_cast<std::size_t>(i)];
      range = { { std::min(range[0], sample), std::max(range[1], sample) } };
    }
  };
  for (int reference : face.Edges)
  {
    const MicroMesh::Edge& edge = mesh.Edges[static_cast<std::size_t>(reference >> 1)];
    add(edge.First, (1 << edge.Level) - 1);
  }
  add(face.FirstInner, face.Level > 0 ? GetNumberOfInnerPoints(1 << face.Level) : 0);
  return range;
}
}

vtkDataArray* FindMicroPointData(vtkPolyData* mesh, vtkDataArray* pointArray)
{
  const std::string name =
    std::string(MicroPointDataPrefix) + (pointArray->GetName() ? pointArray->GetName() : "");
  vtkDataArray* values = mesh->GetFieldData()->GetArray(name.c_str());
  auto faces = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(MicroFacesName));
  if (!values || !faces || faces->GetNumberOfComponents() != 5 ||
    values->GetNumberOfComponents() != pointArray->GetNumberOfComponents())
  {
    return nullptr;
  }
  vtkIdType number = 0;
  for (vtkIdType f = 0; f < faces->GetNumberOfTuples(); ++f)
  {
    const int level = std::max(0, std::min(LargestMicroLevel, faces->GetTypedComponent(f, 4)));
    number += GetNumberOfGridPoints(1 << level);
  }
  return values->GetNumberOfTuples() == number ? values : nullptr;
}

void EvaluateMicroPointData(const vtkRefinementSurface::Face& face, const float weights[3],
  vtkDataArray* values, double* tuple)
{
  MicroMeshFace micro(face);
  const MicroMeshFace::FieldPlace place = micro.fieldPlace(
    micro.surfaceFieldRecord(), micro.surfaceFieldWeights(MicroMeshFace::Load(weights)));
  const int components = values->GetNumberOfComponents();
  std::fill_n(tuple, components, 0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    const double weight = place.Weights[corner];
    for (int c = 0; c < components && weight != 0.0; ++c)
    {
      tuple[c] += weight * values->GetComponent(place.Indices[corner], c);
    }
  }
}

vtkSmartPointer<vtkDataArray> FindMicroCellData(vtkPolyData* mesh, vtkDataArray* cellArray)
{
  const std::string name =
    std::string(MicroCellDataPrefix) + (cellArray->GetName() ? cellArray->GetName() : "");
  vtkDataArray* stored = mesh->GetFieldData()->GetArray(name.c_str());
  auto faces = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(MicroFacesName));
  if (!stored || !faces || faces->GetNumberOfComponents() != 5 ||
    stored->GetDataType() != cellArray->GetDataType() ||
    stored->GetNumberOfComponents() != cellArray->GetNumberOfComponents())
  {
    return nullptr;
  }
  vtkIdType triangles = 0;
  vtkIdType places = 0;
  const auto getLevel = [&](vtkIdType f)
  { return std::max(0, std::min(LargestMicroLevel, faces->GetTypedComponent(f, 4))); };
  for (vtkIdType f = 0; f < faces->GetNumberOfTuples(); ++f)
  {
    triangles += vtkIdType(1) << 2 * getLevel(f);
    places += 2 * GetNumberOfGridPoints(1 << getLevel(f));
  }
  if (stored->GetNumberOfTuples() != triangles)
  {
    return nullptr;
  }
  auto values = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(stored->GetDataType()));
  values->SetName(cellArray->GetName());
  values->SetNumberOfComponents(stored->GetNumberOfComponents());
  values->SetNumberOfTuples(places);
  values->Fill(0.0);
  triangles = 0;
  places = 0;
  for (vtkIdType f = 0; f < faces->GetNumberOfTuples(); ++f)
  {
    const vtkIdType number = vtkIdType(1) << 2 * getLevel(f);
    values->InsertTuples(places, number, triangles, stored);
    triangles += number;
    places += 2 * GetNumberOfGridPoints(1 << getLevel(f));
  }
  return values;
}

vtkIdType FindMicroCellTuple(const vtkRefinementSurface::Face& face, const float weights[3])
{
  MicroMeshFace micro(face);
  return micro.microCell(
    micro.surfaceFieldRecord(), micro.surfaceFieldWeights(MicroMeshFace::Load(weights)));
}

bool BuildMicroMeshTables(
  vtkPolyData* mesh, vtkRefinementSurface::Tables& tables, std::string& error)
{
  MicroMesh micro;
  if (!TakeMicroMesh(mesh, micro, error))
  {
    return false;
  }
  const std::vector<vec3> normals = ComputeSampleNormals(micro);
  for (std::size_t i = 0; i < micro.Samples.size(); ++i)
  {
    tables.Records.push_back(PackSample(micro.Samples[i], normals[i]));
  }
  tables.Records.resize((tables.Records.size() + 3) / 4 * 4, 0);
  int firstGridPoint = 0;
  for (const MicroMesh::Face& face : micro.Faces)
  {
    tables.Entries.push_back(static_cast<int>(tables.Records.size() / 4));
    int levels = face.Level << 12;
    int reversed = 0;
    for (int e = 0; e < 3; ++e)
    {
      const MicroMesh::Edge& edge = micro.Edges[static_cast<std::size_t>(face.Edges[e] >> 1)];
      tables.Records.push_back(edge.First);
      levels |= edge.Level << 4 * e;
      reversed |= (face.Edges[e] & 1) << e;
    }
    tables.Records.push_back(face.FirstInner);
    const std::array<int, 2> range = FindRange(micro, face);
    tables.Records.insert(
      tables.Records.end(), { levels, reversed, range[0], range[1], firstGridPoint, 0, 0, 0 });
    firstGridPoint += GetNumberOfGridPoints(1 << face.Level);
  }
  return true;
}
}
