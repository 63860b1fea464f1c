// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/AttributeSampling.h"

#include "Arrays/NearestTuple.h"
#include "Data/MicroMeshArrays.h"
#include "Distance/TriangleTree.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace relevo
{
namespace
{
// A point of the input's surface.
struct SurfacePoint
{
  DenseMesh::Triangle Points;
  dvec3 Weights;
};

// The triangles of the input beside each triangle, across edges that are not seams.
class TriangleNeighbours
{
public:
  explicit TriangleNeighbours(const std::vector<DenseMesh::Triangle>& triangles)
  {
    struct Side
    {
      std::pair<int, int> Ends;
      int Triangle;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        sides.push_back(
          { std::minmax({ triangles[t][e], triangles[t][(e + 1) % 3] }), static_cast<int>(t) });
      }
    }
    std::sort(sides.begin(), sides.end(),
      [](const Side& a, const Side& b)
      { return std::tie(a.Ends, a.Triangle) < std::tie(b.Ends, b.Triangle); });
    this->Lists.resize(triangles.size());
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    {
      if (sides[i].Ends == sides[i + 1].Ends)
      {
        this->Lists[static_cast<std::size_t>(sides[i].Triangle)].push_back(sides[i + 1].Triangle);
        this->Lists[static_cast<std::size_t>(sides[i + 1].Triangle)].push_back(sides[i].Triangle);
      }
    }
  }

  const std::vector<int>& Get(int triangle) const
  {
    return this->Lists[static_cast<std::size_t>(triangle)];
  }

private:
  std::vector<std::vector<int>> Lists;
};

bool HasSeams(const EncodedMesh& encoded)
{
  return std::any_of(encoded.Base.EdgeFlags.begin(), encoded.Base.EdgeFlags.end(),
    [](unsigned char flags) { return (flags & DenseMesh::SEAM) != 0; });
}

class InputLocator
{
public:
  InputLocator(const DenseMesh& dense, const EncodedMesh& encoded)
    : Dense(dense)
    , Encoded(encoded)
    , Surface(dense.Points, dense.Triangles)
    , AreOnSeam(encoded.Mesh.Points.size(), 0)
  {
    if (!HasSeams(encoded))
    {
      return;
    }
    this->Neighbours = std::make_unique<TriangleNeighbours>(dense.GetAllWedges());
    for (const MicroMesh::Face& face : encoded.Mesh.Faces)
    {
      for (int e = 0; e < 3; ++e)
      {
        const auto edge = static_cast<std::size_t>(face.Edges[e] >> 1);
        if ((encoded.Base.EdgeFlags[edge] & DenseMesh::SEAM) != 0)
        {
          this->AreOnSeam[static_cast<std::size_t>(face.Corners[e])] = 1;
          this->AreOnSeam[static_cast<std::size_t>(face.Corners[(e + 1) % 3])] = 1;
        }
      }
    }
  }

  // Finds the points of the input at the grid points of a face, and the cells of the input at the
  // centres of the grid's triangles.
  void Find(std::size_t f, std::vector<SurfacePoint>& points, std::vector<vtkIdType>& cells) const
  {
    const MicroMesh::Face& face = this->Encoded.Mesh.Faces[f];
    const std::vector<dvec3> positions = this->Encoded.Mesh.GetPositions(face);
    const bool isOnSeam = std::any_of(face.Corners.begin(), face.Corners.end(),
      [this](int corner) { return this->AreOnSeam[static_cast<std::size_t>(corner)] != 0; });
    std::vector<int> numbers;
    std::vector<DenseMesh::Triangle> triangles;
    if (isOnSeam)
    {
      numbers = this->FindSide(this->Encoded.Base.Triangles[f], positions);
      for (int t : numbers)
      {
        triangles.push_back(this->Dense.Triangles[static_cast<std::size_t>(t)]);
      }
    }
    const TriangleTree side(this->Dense.Points, triangles);
    const auto findNearest = [&](const dvec3& position)
    {
      double distance2 = std::numeric_limits<double>::infinity();
      int nearest = 0;
      (isOnSeam ? side : this->Surface).FindNearest(position, distance2, nearest);
      return isOnSeam ? numbers[static_cast<std::size_t>(nearest)] : nearest;
    };
    const int n = 1 << face.Level;
    points.clear();
    ForEachGridPoint(n,
      [&](const GridPoint& grid)
      {
        const auto corner = std::find(grid.begin(), grid.end(), n);
        if (corner != grid.end())
        {
          const int point = this->Encoded.Base.Wedges[f][corner - grid.begin()];
          points.push_back({ { { point, point, point } }, dvec3(1.0, 0.0, 0.0) });
          return;
        }
        const dvec3& position = positions[points.size()];
        points.push_back(this->GetSurfacePoint(position, findNearest(position)));
      });
    cells.clear();
    ForEachGridTriangle(n,
      [&](int a, int b, int c)
      {
        const dvec3 sum = positions[static_cast<std::size_t>(a)] +
          positions[static_cast<std::size_t>(b)] + positions[static_cast<std::size_t>(c)];
        const int nearest = n == 1 ? this->Encoded.Base.Triangles[f] : findNearest(sum / 3.0);
        cells.push_back(this->Dense.GetCell(static_cast<std::size_t>(nearest)));
      });
  }

private:
  // The triangles of the input near a face, without those beyond a seam.
  std::vector<int> FindSide(int start, const std::vector<dvec3>& positions) const
  {
    dvec3 low = positions.front();
    dvec3 high = low;
    for (const dvec3& position : positions)
    {
      low = min(low, position);
      high = max(high, position);
    }
    const double error = std::max(this->Encoded.InputToResult, this->Encoded.ResultToInput);
    const dvec3 margin(2.0 * error / this->Dense.Scale);
    std::vector<int> side{ start };
    std::unordered_set<int> isKnown{ start };
    for (std::size_t i = 0; i < side.size(); ++i)
    {
      for (int t : this->Neighbours->Get(side[i]))
      {
        const DenseMesh::Triangle& corners = this->Dense.Triangles[static_cast<std::size_t>(t)];
        dvec3 lowest = this->Dense.Points[static_cast<std::size_t>(corners[0])];
        dvec3 highest = lowest;
        for (int corner : corners)
        {
          lowest = min(lowest, this->Dense.Points[static_cast<std::size_t>(corner)]);
          highest = max(highest, this->Dense.Points[static_cast<std::size_t>(corner)]);
        }
        const bool isNear =
          all(lessThanEqual(lowest, high + margin)) && all(lessThanEqual(low - margin, highest));
        if (isNear && isKnown.insert(t).second)
        {
          side.push_back(t);
        }
      }
    }
    return side;
  }

  // The point of a triangle nearest to a position.
  SurfacePoint GetSurfacePoint(const dvec3& position, int triangle) const
  {
    const auto t = static_cast<std::size_t>(triangle);
    dvec3 x[3];
    for (int c = 0; c < 3; ++c)
    {
      x[c] = this->Dense.Points[static_cast<std::size_t>(this->Dense.Triangles[t][c])];
    }
    const dvec3 place = this->Surface.GetNearestPoint(position, triangle);
    const dvec3 normal = cross(x[1] - x[0], x[2] - x[0]);
    dvec3 weights(0.0);
    for (int c = 0; c < 3; ++c)
    {
      const dvec3& a = x[(c + 1) % 3];
      weights[c] = std::max(0.0, dot(normal, cross(x[(c + 2) % 3] - a, place - a)));
    }
    const double sum = weights.x + weights.y + weights.z;
    return { this->Dense.GetWedges(t), sum > 0.0 ? weights / sum : dvec3(1.0, 0.0, 0.0) };
  }

  const DenseMesh& Dense;
  const EncodedMesh& Encoded;
  TriangleTree Surface;
  std::vector<char> AreOnSeam; // per point of the micro-mesh
  std::unique_ptr<TriangleNeighbours> Neighbours;
};

struct SampledArray
{
  vtkDataArray* From;
  vtkSmartPointer<vtkDataArray> To;
};

// Makes arrays for those that are sampled.
std::vector<SampledArray> MakeArrays(
  vtkDataSetAttributes* data, const char* prefix, vtkIdType tuples)
{
  std::vector<SampledArray> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array || !array->GetName() || array->GetDataType() == VTK_ID_TYPE ||
      array->GetDataType() == VTK_BIT || array == data->GetNormals() ||
      array == data->GetGlobalIds() || std::string(array->GetName()) == "Normals" ||
      std::string(array->GetName()) == vtkDataSetAttributes::GhostArrayName())
    {
      continue;
    }
    auto to = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
    to->SetName((prefix + std::string(array->GetName())).c_str());
    to->SetNumberOfComponents(array->GetNumberOfComponents());
    to->SetNumberOfTuples(tuples);
    arrays.push_back({ array, to });
  }
  return arrays;
}

void Interpolate(const SampledArray& array, const SurfacePoint& point, vtkIdType tuple,
  std::vector<double>& value, std::vector<double>& sum)
{
  const auto components = static_cast<std::size_t>(array.From->GetNumberOfComponents());
  value.resize(components);
  sum.assign(components, 0.0);
  for (int c = 0; c < 3; ++c)
  {
    if (point.Weights[c] > 0.0)
    {
      array.From->GetTuple(point.Points[c], value.data());
      for (std::size_t i = 0; i < components; ++i)
      {
        sum[i] += point.Weights[c] * value[i];
      }
    }
  }
  SetNearestTuple(array.To, tuple, sum.data());
}
}

void SampleAttributes(
  const DenseMesh& dense, const EncodedMesh& encoded, vtkPolyData* input, vtkPolyData* output)
{
  const std::vector<MicroMesh::Face>& faces = encoded.Mesh.Faces;
  std::vector<vtkIdType> firstPoints{ 0 };
  std::vector<vtkIdType> firstTriangles{ 0 };
  for (const MicroMesh::Face& face : faces)
  {
    firstPoints.push_back(firstPoints.back() + GetNumberOfGridPoints(1 << face.Level));
    firstTriangles.push_back(firstTriangles.back() + (vtkIdType(1) << 2 * face.Level));
  }
  const std::vector<SampledArray> ofPoints =
    MakeArrays(input->GetPointData(), MicroPointDataPrefix, firstPoints.back());
  const std::vector<SampledArray> ofCells =
    MakeArrays(input->GetCellData(), MicroCellDataPrefix, firstTriangles.back());
  if (ofPoints.empty() && ofCells.empty())
  {
    return;
  }
  const InputLocator locator(dense, encoded);
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<SurfacePoint> points;
      std::vector<vtkIdType> cells;
      std::vector<double> value;
      std::vector<double> sum;
      for (auto f = static_cast<std::size_t>(begin); f < static_cast<std::size_t>(end); ++f)
      {
        locator.Find(f, points, cells);
        for (const SampledArray& array : ofPoints)
        {
          for (std::size_t i = 0; i < points.size(); ++i)
          {
            Interpolate(array, points[i], firstPoints[f] + static_cast<vtkIdType>(i), value, sum);
          }
        }
        for (const SampledArray& array : ofCells)
        {
          for (std::size_t i = 0; i < cells.size(); ++i)
          {
            array.To->SetTuple(firstTriangles[f] + static_cast<vtkIdType>(i), cells[i], array.From);
          }
        }
      }
    });
  for (const std::vector<SampledArray>& arrays : { ofPoints, ofCells })
  {
    for (const SampledArray& array : arrays)
    {
      output->GetFieldData()->AddArray(array.To);
    }
  }
}
}
