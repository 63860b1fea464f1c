// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkIntersectionPairs.h"

#include "BenchmarkIntersectionWay.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkWorker.h"
#include "RelevoTrianglePairs.h"

#include "vtkObject.h"

#include <cstdlib>

namespace
{
using Policy = BenchmarkIntersectionWay;

enum Figure
{
  Meeting,
  TooMany,
  TooFew,
  Crossing,
  TooFewCrossing,
  Seconds
};

BenchmarkWorker::Figures MeasurePair(Policy::Kind kind, int number)
{
  RelevoDice dice(static_cast<unsigned int>(number));
  const int side = 3 + number % 6;
  const RelevoWholeMesh first(dice, side, 8, 12);
  const RelevoWholeMesh second(dice, side, 7, 10);
  const auto firstMesh = first.NewPolyData();
  const auto secondMesh = second.NewPolyData();
  BenchmarkWorker::Figures figures{};
  const Stopwatch watch;
  Policy way(kind, firstMesh, secondMesh);
  way.Update();
  figures[Seconds] = watch.GetSeconds();
  const Policy::Pairs found = way.GetPairs();
  const Policy::Pairs unnamed = way.GetUnnamedPairs();
  figures[TooMany] = static_cast<double>(found.size());
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 10; ++j)
    {
      const auto a = first.GetCorners(i);
      const auto b = second.GetCorners(j);
      if (RelevoMeet(a, b))
      {
        const bool isNamed = found.count({ i, j }) != 0;
        const bool isFound = isNamed || unnamed.count({ i, j }) != 0;
        const bool isCrossing = RelevoCross(a, b);
        figures[Meeting] += 1.0;
        figures[Crossing] += isCrossing;
        figures[TooMany] -= isNamed;
        figures[TooFew] += !isFound;
        figures[TooFewCrossing] += isCrossing && !isFound;
      }
    }
  }
  return figures;
}
}

std::vector<double> MeasureIntersectionPairs(const std::vector<std::string>& arguments)
{
  vtkObject::GlobalWarningDisplayOff(); // warnings about open meshes and edges with many triangles
  const auto kind = static_cast<Policy::Kind>(std::atoi(arguments.at(1).c_str()));
  const BenchmarkWorker worker(std::atoi(arguments.at(2).c_str()), 2,
    [kind](int number) { return MeasurePair(kind, number); });
  std::vector<double> values(worker.Sums.begin(), worker.Sums.end());
  for (const int count : { worker.Finished, worker.Crashes, worker.Hangs })
  {
    values.push_back(count);
  }
  return values;
}

void AddIntersectionPairs(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("intersections-pairs",
    "Pairs of small meshes with whole coordinates, against exact arithmetic",
    { { "filter", "filter", 0 }, { "mesh_pairs", "pairs of meshes", 0 },
      { "crashes", "crashes", 0 }, { "hangs", "hangs", 0 }, { "meeting", "triangles that meet", 0 },
      { "too_many", "too many", 0 }, { "too_few", "too few", 0 },
      { "crossing", "of them that cross", 0 }, { "too_few_crossing", "too few", 0 },
      { "us", "us a pair of meshes", 0 } });
  struct Contestant
  {
    Policy::Kind Kind;
    int Number;
  };
  const int all = options.Quick ? 60 : 100000;
  const int some = options.Quick ? 20 : 10000;
  for (const Contestant& contestant :
    { Contestant{ Policy::Exact, all }, Contestant{ Policy::Collisions, some },
      Contestant{ Policy::Lines, some }, Contestant{ Policy::Splits, options.Quick ? 5 : 500 } })
  {
    const auto values = RunInOwnProcess({ "intersections", "pairs",
      std::to_string(static_cast<int>(contestant.Kind)), std::to_string(contestant.Number) });
    if (values.size() == 9)
    {
      table.AddRow({ Policy::GetName(contestant.Kind), static_cast<double>(contestant.Number),
        values[7], values[8], values[Meeting], values[TooMany], values[TooFew], values[Crossing],
        values[TooFewCrossing], 1e6 * values[Seconds] / values[6] });
    }
  }
  table.AddNote(
    "12 and 10 random triangles of coordinates from 0 to 2, up to 7. Triangles are "
    "counted where the filter came to an end; a hang is one that takes 2 seconds. "
    "Crossing: their insides meet, not in one plane; others touch, or overlap. A line of "
    "vtkIntersectionPolyDataFilter tells of all triangles that it is in, though it "
    "has the ids of two. Asked "
    "of vtkSurfaceIntersectionFilter: none too many, none too few, no crash, no hang.");
  addTable(table);
}
