// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFrames.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeWay.h"
#include "Benchmarks.h"

#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

namespace
{
constexpr int Nodes = 11;
constexpr double Turn = 7.0;  // degrees per frame
constexpr double Jump = 0.02; // of the range of values around 1

using Mesh = vtkSmartPointer<vtkUnstructuredGrid>;

// Gives each cell its own points, and values that differ from those of its neighbours.
Mesh TakeApart(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  auto apart = Mesh::New();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    const double jump = Jump * static_cast<double>(cell % 3 - 1);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType from = corners->GetId(i);
      values->InsertNextValue(
        static_cast<float>(mesh->GetPointData()->GetScalars()->GetTuple1(from) + jump));
      corners->SetId(i, points->InsertNextPoint(mesh->GetPoint(from)));
    }
    apart->InsertNextCell(mesh->GetCellType(cell), corners);
  }
  apart->SetPoints(points);
  apart->GetPointData()->SetScalars(values);
  return apart;
}

// A unit cube of n^3 cubes. Those with x above `refinedFrom` are divided into eight.
Mesh MakeCubes(int n, double refinedFrom)
{
  using Steps = std::array<int, 3>; // halves of a cube
  std::map<Steps, vtkIdType> known;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  auto mesh = Mesh::New();
  const auto add = [&](const Steps& low, int size)
  {
    std::array<vtkIdType, 8> corners;
    for (int i = 0; i < 8; ++i)
    {
      const Steps at = { { low[0] + size * ((i + 1) >> 1 & 1), low[1] + size * (i >> 1 & 1),
        low[2] + size * (i >> 2) } };
      const auto [found, isNew] = known.insert({ at, points->GetNumberOfPoints() });
      if (isNew)
      {
        const double x = 0.5 * at[0] / n - 0.5;
        const double y = 0.5 * at[1] / n - 0.5;
        const double z = 0.5 * at[2] / n - 0.5;
        points->InsertNextPoint(x, y, z);
        values->InsertNextValue(static_cast<float>(
          std::sin(5.0 * x + 1.0) * std::cos(4.0 * y) + std::sqrt(x * x + y * y + z * z)));
      }
      corners[i] = found->second;
    }
    mesh->InsertNextCell(VTK_HEXAHEDRON, 8, corners.data());
  };
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    const Steps low = { { 2 * (cube % n), 2 * (cube / n % n), 2 * (cube / n / n) } };
    const bool isRefined = low[0] >= 2.0 * n * refinedFrom;
    for (int i = 0; i < (isRefined ? 8 : 1); ++i)
    {
      add({ { low[0] + (i & 1), low[1] + (i >> 1 & 1), low[2] + (i >> 2) } }, isRefined ? 1 : 2);
    }
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

class Comparison
{
public:
  Comparison(const BenchmarkOptions& options, const BenchmarkVolumeScene& scene)
    : Options(options)
    , Scene(scene)
    , Table("volumes-neighbors", "Volumes of cells that do not share all points",
        { { "mesh", "mesh", 0 }, { "cells", "cells", 0 }, { "ms", "ms", 1 },
          { "against", "against", 0 }, { "against_ms", "ms", 1 }, { "ratio", "ratio", 3 },
          { "ratio_processor", "of processor time", 3 }, { "asked", "asked", 2 } })
  {
  }

  void Add(const std::string& name, vtkUnstructuredGrid* mesh, const std::string& against,
    vtkUnstructuredGrid* other, double asked)
  {
    std::cerr << "volumes: " << name << std::endl;
    const auto property = this->Scene.MakeProperty(other, Nodes);
    const vtkSmartPointer<vtkVolume> volumes[] = { MakeVolume(VolumeWay::Exact, mesh, property),
      MakeVolume(VolumeWay::Exact, other, property) };
    const int size = this->Options.Quick ? 64 : 512;
    BenchmarkView view(size, size);
    view.LookAt(other->GetBounds());
    BenchmarkFrames frames(view, { volumes[0], volumes[1] });
    frames.SetTurn(Turn);
    frames.Measure(this->Options.Quick ? 1 : 7);
    this->Table.AddRow({ name, static_cast<double>(mesh->GetNumberOfCells()), frames.GetMedian(0),
      against, frames.GetMedian(1), frames.GetRatio(0, 1), frames.GetProcessorRatio(0, 1), asked });
  }

  const BenchmarkTable& GetTable() const { return this->Table; }

private:
  const BenchmarkOptions& Options;
  const BenchmarkVolumeScene& Scene;
  BenchmarkTable Table;
};
}

void RunVolumeNeighbors(const BenchmarkOptions& options, const AddTable& addTable)
{
  const int n = options.Quick ? 4 : 24;
  const BenchmarkVolumeScene scene("grid " + std::to_string(n));
  Comparison comparison(options, scene);
  for (const auto split : { BenchmarkVolumeScene::UNSPLIT, BenchmarkVolumeScene::FIVE })
  {
    const Mesh mesh = scene.MakeMesh(split);
    const bool isSplit = split != BenchmarkVolumeScene::UNSPLIT;
    comparison.Add(isSplit ? "discontinuous tetrahedra" : "discontinuous hexahedra",
      TakeApart(mesh), "continuous", mesh, 1.3);
  }
  comparison.Add(
    "hexahedra, half of them refined", MakeCubes(n, 0.5), "all refined", MakeCubes(n, 0.0), 1.0);
  addTable(comparison.GetTable());
}
