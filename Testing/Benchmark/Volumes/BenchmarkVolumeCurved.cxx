// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeWay.h"
#include "Benchmarks.h"

#include "vtkCellType.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{
constexpr int CurvedDegree = 3;
constexpr double CurvedTurn = 7.0; // degrees per frame

// n^3 cubic Lagrange hexahedra in a cube with bent faces, with a smooth field.
vtkSmartPointer<vtkUnstructuredGrid> MakeCurved(int n)
{
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> field;
  field->SetName("Scalars");
  const int side = CurvedDegree * n + 1;
  for (int i = 0; i < side * side * side; ++i)
  {
    const double x = static_cast<double>(i % side) / (side - 1);
    const double y = static_cast<double>(i / side % side) / (side - 1);
    const double z = static_cast<double>(i / side / side) / (side - 1);
    points->InsertNextPoint(x, y + 0.15 * std::sin(3.0 * x), z + 0.1 * std::sin(4.0 * x * y));
    field->InsertNextValue(
      0.5 + 0.25 * std::sin(5.0 * x + 1.0) * std::cos(4.0 * y) + 0.25 * std::sin(4.0 * z));
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(field);
  const int order[4] = { CurvedDegree, CurvedDegree, CurvedDegree, 64 };
  std::array<vtkIdType, 64> ids;
  for (int cell = 0; cell < n * n * n; ++cell)
  {
    for (int node = 0; node < 64; ++node)
    {
      const std::array<int, 3> at = { { node % 4, node / 4 % 4, node / 16 } };
      const int x = CurvedDegree * (cell % n) + at[0];
      const int y = CurvedDegree * (cell / n % n) + at[1];
      const int z = CurvedDegree * (cell / n / n) + at[2];
      ids[static_cast<size_t>(vtkHigherOrderHexahedron::PointIndexFromIJK(
        at[0], at[1], at[2], order))] = x + side * (y + side * z);
    }
    mesh->InsertNextCell(VTK_LAGRANGE_HEXAHEDRON, 64, ids.data());
  }
  return mesh;
}

// The times of the first picture and of the frames after it. `prepare` returns the volume and
// belongs to the first picture.
std::vector<double> TimeWay(const std::function<vtkSmartPointer<vtkVolume>()>& prepare,
  vtkUnstructuredGrid* mesh, int size, int rounds, double& first)
{
  BenchmarkView view(size, size);
  view.LookAt(mesh->GetBounds());
  view.TimeFrame();
  const Stopwatch stopwatch;
  const auto volume = prepare();
  view.GetRenderer()->AddViewProp(volume);
  view.TimeFrame();
  first = stopwatch.GetSeconds();
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round)
  {
    view.MoveCamera(CurvedTurn);
    seconds.push_back(view.TimeFrame());
  }
  return seconds;
}
}

void RunVolumeCurved(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("volumes-curved", "Volumes of cubic Lagrange hexahedra",
    { { "cells", "cells", 0 }, { "way", "against vtkDataSetTriangleFilter and", 0 },
      { "first_ms", "first picture, ms", 1 }, { "their_first_ms", "theirs, ms", 1 },
      { "ratio_first", "ratio", 3 }, { "asked_first", "asked", 2 }, { "frame_ms", "frame, ms", 1 },
      { "their_frame_ms", "theirs, ms", 1 }, { "ratio_frame", "ratio", 3 },
      { "asked_frame", "asked", 2 } });
  const int size = options.Quick ? 64 : 512;
  const int rounds = options.Quick ? 1 : 3;
  const auto mesh = MakeCurved(options.Quick ? 2 : 16);
  const BenchmarkVolumeScene scene("grid 2"); // for its functions
  const auto property = scene.MakeProperty(mesh, 3);
  double first = 0.0;
  const std::vector<double> ours = TimeWay(
    [&] { return MakeVolume(VolumeWay::Exact, mesh, property); }, mesh, size, rounds, first);
  for (const VolumeWay way : { VolumeWay::VTKProjected, VolumeWay::VTKLinear })
  {
    double theirFirst = 0.0;
    const auto split = [&]
    {
      vtkNew<vtkDataSetTriangleFilter> filter;
      filter->SetInputData(mesh);
      filter->TetrahedraOnlyOn();
      filter->Update();
      return MakeVolume(way, filter->GetOutput(), property);
    };
    const std::vector<double> theirs = TimeWay(split, mesh, size, rounds, theirFirst);
    std::cerr << "volumes: curved cells: " << first / theirFirst << ", "
              << GetMedianRatio(ours, theirs) << std::endl;
    table.AddRow({ static_cast<double>(mesh->GetNumberOfCells()), std::string(GetName(way)),
      1e3 * first, 1e3 * theirFirst, first / theirFirst, 0.3, 1e3 * GetMedian(ours),
      1e3 * GetMedian(theirs), GetMedianRatio(ours, theirs), 0.5 });
  }
  table.AddNote(std::to_string(size) + " x " + std::to_string(size) +
    " pixels, the camera turns, medians of frames. The first picture includes the division of "
    "cells "
    "and building the shaders. Theirs are linear between the nodes.");
  addTable(table);
}
