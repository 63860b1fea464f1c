// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/MicroMeshOutput.h"

#include "Arrays/CellDataCopy.h"
#include "Data/LevelErrors.h"
#include "Data/MicroMeshArrays.h"
#include "Data/MicroNormals.h"
#include "Mathematics/DisjointSets.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace relevo
{
namespace
{
// The points of the output: sets of corners of faces that have the same point and normal.
class OutputPoints
{
public:
  OutputPoints(const BaseMesh& base, const MicroMesh& mesh)
    : Numbers(3 * mesh.Faces.size(), -1)
  {
    DisjointSets corners(static_cast<vtkIdType>(3 * mesh.Faces.size()));
    std::vector<int> others(mesh.Edges.size(), -1); // the first side of each edge
    for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
    {
      for (int e = 0; e < 3; ++e)
      {
        const auto edge = static_cast<std::size_t>(mesh.Faces[f].Edges[e] >> 1);
        const int side = 3 * static_cast<int>(f) + e;
        const int splitting = DenseMesh::SHARP | DenseMesh::UNCLEAR;
        if (others[edge] >= 0 && (base.EdgeFlags[edge] & splitting) == 0)
        {
          const int other = others[edge];
          UniteIfSame(base, corners, side, GetNext(other));
          UniteIfSame(base, corners, GetNext(side), other);
        }
        others[edge] = side;
      }
    }
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      const auto set = static_cast<std::size_t>(corners.Find(static_cast<vtkIdType>(i)));
      if (this->Numbers[set] < 0) // the lowest number of the set comes first
      {
        this->Numbers[set] = static_cast<int>(this->Firsts.size());
        this->Firsts.push_back(static_cast<int>(i));
      }
      this->Numbers[i] = this->Numbers[set];
    }
  }

  std::vector<int> Numbers; // per corner, 3 * face + corner
  std::vector<int> Firsts;  // per point, its first corner

private:
  static int GetNext(int corner) { return corner / 3 * 3 + (corner % 3 + 1) % 3; }
  static void UniteIfSame(const BaseMesh& base, DisjointSets& corners, int a, int b)
  {
    if (base.Wedges[static_cast<std::size_t>(a / 3)][a % 3] ==
      base.Wedges[static_cast<std::size_t>(b / 3)][b % 3])
    {
      corners.Unite(a, b);
    }
  }
};

void StorePoints(const OutputPoints& points, const BaseMesh& base, const MicroMesh& mesh,
  vtkPolyData* input, vtkPolyData* output)
{
  const auto number = static_cast<vtkIdType>(points.Firsts.size());
  vtkNew<vtkPoints> places;
  places->SetDataType(input->GetPoints()->GetDataType());
  places->SetNumberOfPoints(number);
  vtkPointData* data = output->GetPointData();
  data->CopyNormalsOff();
  data->CopyGlobalIdsOff();
  data->CopyAllocate(input->GetPointData(), number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    const int corner = points.Firsts[static_cast<std::size_t>(i)];
    const int point = base.Wedges[static_cast<std::size_t>(corner / 3)][corner % 3];
    const int vertex = mesh.Faces[static_cast<std::size_t>(corner / 3)].Corners[corner % 3];
    const dvec3& place = base.Places[static_cast<std::size_t>(vertex)];
    places->SetPoint(i, place.x, place.y, place.z);
    data->CopyData(input->GetPointData(), point, i);
  }
  data->RemoveArray(MicroNormalsName);
  output->SetPoints(places);
}
}

void StoreEncodedMesh(
  const DenseMesh& dense, const EncodedMesh& encoded, vtkPolyData* input, vtkPolyData* output)
{
  const MicroMesh& mesh = encoded.Mesh;
  const OutputPoints points(encoded.Base, mesh);
  StorePoints(points, encoded.Base, mesh, input, output);
  MicroMesh stored = mesh;
  stored.Directions.clear();
  for (int corner : points.Firsts)
  {
    const int point = mesh.Faces[static_cast<std::size_t>(corner / 3)].Corners[corner % 3];
    stored.Directions.push_back(
      mesh.Directions[static_cast<std::size_t>(point)] * static_cast<float>(dense.Scale));
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdTypeArray> cells;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const vtkIdType corners[3] = { points.Numbers[3 * f], points.Numbers[3 * f + 1],
      points.Numbers[3 * f + 2] };
    triangles->InsertNextCell(3, corners);
    cells->InsertNextValue(dense.GetCell(static_cast<std::size_t>(encoded.Base.Triangles[f])));
  }
  output->SetPolys(triangles);
  std::vector<std::string> shortArrays; // the filter has removed them
  CopyCellData(input, cells, false, output->GetCellData(), shortArrays);
  StoreMicroMesh(stored, output);
  MicroMesh written;
  std::string invalid;
  if (TakeMicroMesh(output, written, invalid))
  {
    output->GetPointData()->SetNormals(MakePointNormals(written));
    output->GetCellData()->AddArray(MakeLevelErrors(written));
  }
  vtkNew<vtkDoubleArray> error;
  error->SetName(MicroErrorName);
  error->InsertNextValue(encoded.InputToResult);
  error->InsertNextValue(encoded.ResultToInput);
  output->GetFieldData()->AddArray(error);
}
}
