// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkIntersectionTimes.h"

#include "BenchmarkIntersectionWay.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkMeshes.h"
#include "BenchmarkReport.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

namespace
{
using Policy = BenchmarkIntersectionWay;
constexpr std::array<Policy::Kind, 3> Ways = { Policy::Exact, Policy::Lines, Policy::Collisions };

// Copies a mesh without the structures that it builds when it is used.
vtkSmartPointer<vtkPolyData> Renew(vtkPolyData* mesh)
{
  auto renewed = vtkSmartPointer<vtkPolyData>::New();
  renewed->SetPoints(mesh->GetPoints());
  renewed->SetPolys(mesh->GetPolys());
  return renewed;
}

struct Contest
{
  explicit Contest(vtkPolyData* mesh)
    : Mesh(mesh)
  {
    const double* bounds = mesh->GetBounds();
    this->Motion->Translate(0.3 * (bounds[1] - bounds[0]), 0.1 * (bounds[3] - bounds[2]), 0.0);
    this->Motion->RotateY(20.0);
  }

  // Measures all ways in turn, for new meshes and after moves.
  void Run(int rounds, int moves)
  {
    for (int round = 0; round < rounds; ++round)
    {
      std::array<std::unique_ptr<Policy>, Ways.size()> ways;
      for (std::size_t i = 0; i < ways.size(); ++i)
      {
        ways[i] = std::make_unique<Policy>(Ways[i], Renew(this->Mesh), Renew(this->Mesh));
        this->First[i].push_back(this->Time(*ways[i]));
      }
      for (int move = 0; move < moves; ++move)
      {
        this->Motion->RotateY(1.0);
        for (std::size_t i = 0; i < ways.size(); ++i)
        {
          this->Moved[i].push_back(this->Time(*ways[i]));
          this->Found[i] = static_cast<double>(ways[i]->GetNumberOfSegments());
        }
      }
    }
  }

  using Times = std::array<std::vector<double>, Ways.size()>;
  Times First;
  Times Moved;
  std::array<double, Ways.size()> Found{};

private:
  double Time(Policy& way) const
  {
    way.Move(this->Motion->GetMatrix());
    const Stopwatch watch;
    way.Update();
    return watch.GetSeconds();
  }

  vtkPolyData* Mesh;
  vtkNew<vtkTransform> Motion;
};

void AddRow(const std::string& name, double triangles, const Contest::Times& times, double asked,
  BenchmarkTable& table)
{
  std::vector<double> faster(times[1].size());
  std::transform(times[1].begin(), times[1].end(), times[2].begin(), faster.begin(),
    [](double a, double b) { return std::min(a, b); });
  table.AddRow({ name, triangles, 1e3 * GetMedian(times[0]), 1e3 * GetMedian(times[1]),
    1e3 * GetMedian(times[2]), GetMedianRatio(times[0], faster), asked });
}
}

void AddIntersectionTimes(const BenchmarkOptions& options, const AddTable& addTable)
{
  auto mesh = BenchmarkMeshes::ReadBunny();
  if (!mesh)
  {
    std::cerr << "relevo-benchmark: without RELEVO_TEST_DATA and its mesh/bunny.ply there is no "
                 "table of a bunny against another"
              << std::endl;
    return;
  }
  if (options.Quick)
  {
    mesh = BenchmarkMeshes::Decimate(mesh, 2000);
  }
  BenchmarkTable table("intersections-times", "The bunny against the bunny moved",
    { { "time", "", 0 }, { "triangles", "triangles each", 0 },
      { "exact_ms", Policy::GetName(Policy::Exact) + ", ms", 1 },
      { "lines_ms", Policy::GetName(Policy::Lines) + ", ms", 1 },
      { "collisions_ms", Policy::GetName(Policy::Collisions) + ", ms", 1 },
      { "ratio", "to the faster of these", 3 }, { "asked", "asked", 2 } });
  Contest contest(mesh);
  contest.Run(options.Quick ? 1 : 3, options.Quick ? 2 : 4);
  const auto triangles = static_cast<double>(mesh->GetNumberOfPolys());
  AddRow("first", triangles, contest.First, 0.5, table);
  AddRow("after a move", triangles, contest.Moved, 0.1, table);
  std::string found;
  for (const double number : contest.Found)
  {
    found += (found.empty() ? "" : ", ") + std::to_string(static_cast<int>(number));
  }
  table.AddNote("Wall clock, all in turn, a ratio for each turn. vtkIntersectionPolyDataFilter "
                "does not split, and gets the moved mesh ready; vtkCollisionDetectionFilter finds "
                "all contacts. Moves turn by 1 degree. Found after the last: " +
    found + " segments.");
  addTable(table);
}
