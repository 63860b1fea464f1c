// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/TerrainMesh.h"

#include "Geodesy/TerrainFrame.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
// A grid of (u, v) in [0, 1]^2, which is regular unless it has lines.
struct Grid
{
  int Cells[2];
  std::vector<double> Lines[2];

  vtkIdType NumberOfPoints() const { return (this->Cells[0] + 1LL) * (this->Cells[1] + 1LL); }
  vtkIdType NumberOfCells() const
  {
    return static_cast<vtkIdType>(this->Cells[0]) * this->Cells[1];
  }
  vtkIdType Point(int i, int j) const { return j * (this->Cells[0] + 1LL) + i; }
  double Parameter(int axis, int i) const
  {
    return this->Lines[axis].empty() ? static_cast<double>(i) / this->Cells[axis]
                                     : this->Lines[axis][i];
  }
};

// Chooses cells that are about square and not finer than the texels.
Grid divide(const std::array<double, 2>& lengths, const int texels[2], int resolution)
{
  Grid grid;
  const double longer = std::max(lengths[0], lengths[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double cells = std::round(resolution * (lengths[axis] / longer));
    grid.Cells[axis] = static_cast<int>(std::clamp(cells, 1.0, static_cast<double>(texels[axis])));
  }
  return grid;
}

// Moves the lines of a grid to the centres of texels, a power of two texels apart, so that patterns
// have vertices at the centres. The outer half of the outermost texels gets squares of half a
// texel.
void align(Grid& grid, const int texels[2])
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const int n = texels[axis];
    if (n < 2)
    {
      continue;
    }
    const double spacing = static_cast<double>(n) / grid.Cells[axis];
    const int step = 1 << static_cast<int>(std::lround(std::log2(spacing)));
    std::vector<double>& lines = grid.Lines[axis];
    lines.push_back(0.0);
    for (int texel = 0; texel < n - 1; texel += step)
    {
      lines.push_back((texel + 0.5) / n);
    }
    lines.insert(lines.end(), { (n - 0.5) / n, 1.0 });
    grid.Cells[axis] = static_cast<int>(lines.size()) - 1;
  }
}

// Range of the texels that bilinear interpolation uses between two parameters on one axis.
void texelRange(double begin, double end, int texels, int range[2])
{
  range[0] = std::clamp(static_cast<int>(std::floor(begin * texels - 0.5)), 0, texels - 1);
  range[1] = std::clamp(static_cast<int>(std::ceil(end * texels - 0.5)), 0, texels - 1);
}

// For each square, whether interpolation in it uses any valid sample.
std::vector<unsigned char> findSquaresWithData(
  const Grid& grid, const int texels[2], const unsigned char* validity)
{
  std::vector<unsigned char> hasData(grid.NumberOfCells());
  vtkSMPTools::For(0, grid.Cells[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int j = static_cast<int>(begin); j < end; ++j)
      {
        int rows[2];
        texelRange(grid.Parameter(1, j), grid.Parameter(1, j + 1), texels[1], rows);
        for (int i = 0; i < grid.Cells[0]; ++i)
        {
          int columns[2];
          texelRange(grid.Parameter(0, i), grid.Parameter(0, i + 1), texels[0], columns);
          bool found = false;
          for (int row = rows[0]; row <= rows[1] && !found; ++row)
          {
            const unsigned char* first = validity + static_cast<std::size_t>(row) * texels[0];
            found = std::find_if(first + columns[0], first + columns[1] + 1,
                      [](unsigned char valid) { return valid != 0; }) != first + columns[1] + 1;
          }
          hasData[static_cast<std::size_t>(j) * grid.Cells[0] + i] = found;
        }
      }
    });
  return hasData;
}

// Whether a row degenerates to a point, a pole.
bool isPole(const TerrainFrame& frame, const Grid& grid, int j)
{
  std::array<double, 2> places[2];
  std::array<double, 2> next;
  const double v = grid.Parameter(1, j);
  frame.Place(0.0, v, places[0]);
  frame.Place(0.5, v, places[1]);
  frame.Place(0.5, grid.Parameter(1, j > 0 ? j - 1 : 1), next);
  const auto distance = [&](const std::array<double, 2>& place)
  { return std::hypot(place[0] - places[1][0], place[1] - places[1][1]); };
  return distance(places[0]) < 1e-6 * distance(next);
}

// Generates right triangles with alternating diagonals, which prefer no direction. Triangles with
// two corners at a pole are omitted. `gridPoint` returns i and j of the points in use.
bool addTriangles(const TerrainFrame& frame, const Grid& grid,
  const std::vector<unsigned char>& kept, const std::function<bool()>& goesOn,
  std::vector<int>& gridPoint, vtkPolyData* output)
{
  std::vector<vtkIdType> outputPoint(grid.NumberOfPoints(), -1);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(2 * grid.NumberOfCells(), 6 * grid.NumberOfCells());
  const auto point = [&](int i, int j)
  {
    vtkIdType& id = outputPoint[grid.Point(i, j)];
    if (id < 0)
    {
      id = static_cast<vtkIdType>(gridPoint.size() / 2);
      gridPoint.insert(gridPoint.end(), { i, j });
    }
    return id;
  };
  const bool startsAtPole = isPole(frame, grid, 0);
  const bool endsAtPole = isPole(frame, grid, grid.Cells[1]);
  for (int j = 0; j < grid.Cells[1]; ++j)
  {
    if (!goesOn())
    {
      return false;
    }
    for (int i = 0; i < grid.Cells[0]; ++i)
    {
      if (!kept[static_cast<std::size_t>(j) * grid.Cells[0] + i])
      {
        continue;
      }
      const vtkIdType corners[4] = { point(i, j), point(i + 1, j), point(i + 1, j + 1),
        point(i, j + 1) };
      const int start = (i + j) % 2;
      for (int half : { 0, 2 })
      {
        // The right angle of a triangle is at its second corner.
        const int corner = (start + half + 1) % 4;
        if ((corner < 2 && startsAtPole && j == 0) ||
          (corner >= 2 && endsAtPole && j + 1 == grid.Cells[1]))
        {
          continue;
        }
        triangles->InsertNextCell({ corners[(start + half) % 4], corners[(start + half + 1) % 4],
          corners[(start + half + 2) % 4] });
      }
    }
  }
  output->SetPolys(triangles);
  return true;
}

void addPoints(const TerrainFrame& frame, const Grid& grid, const std::vector<int>& gridPoint,
  vtkPolyData* output)
{
  const vtkIdType numberOfPoints = static_cast<vtkIdType>(gridPoint.size() / 2);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkFloatArray> textureCoordinates;
  textureCoordinates->SetName("TextureCoordinates");
  textureCoordinates->SetNumberOfComponents(2);
  textureCoordinates->SetNumberOfTuples(numberOfPoints);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const double u = grid.Parameter(0, gridPoint[2 * id]);
        const double v = grid.Parameter(1, gridPoint[2 * id + 1]);
        std::array<double, 2> place;
        frame.Place(u, v, place);
        const float xyz[3] = { static_cast<float>(place[0]), static_cast<float>(place[1]), 0.0f };
        const float up[3] = { 0.0f, 0.0f, 1.0f };
        const float uv[2] = { static_cast<float>(u), static_cast<float>(v) };
        coordinates->SetTypedTuple(id, xyz);
        normals->SetTypedTuple(id, up);
        textureCoordinates->SetTypedTuple(id, uv);
      }
    });

  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->SetTCoords(textureCoordinates);
}
}

bool BuildTerrainMesh(const TerrainFrame& frame, const int texels[2], int resolution,
  bool isAligned, const unsigned char* validity, const std::function<bool()>& goesOn,
  vtkPolyData* output)
{
  Grid grid = divide(frame.GetLengths(), texels, resolution);
  if (isAligned)
  {
    align(grid, texels);
  }
  std::vector<int> gridPoint;
  const bool isComplete = addTriangles(frame, grid,
    validity ? findSquaresWithData(grid, texels, validity)
             : std::vector<unsigned char>(grid.NumberOfCells(), 1),
    goesOn, gridPoint, output);
  if (isComplete)
  {
    addPoints(frame, grid, gridPoint, output);
  }
  return isComplete;
}
}
