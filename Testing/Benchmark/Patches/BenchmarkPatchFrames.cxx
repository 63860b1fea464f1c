// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPatchFrames.h"

#include "BenchmarkFrames.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkPatchMeshes.h"
#include "BenchmarkPatchWay.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cstdlib>
#include <limits>
#include <memory>

namespace
{
using Policy = BenchmarkPatchWay;
const std::array<Policy::Kind, 3> Ways = { Policy::Linear, Policy::Exact, Policy::Even };

struct FirstPictures
{
  // Measures the ways in turn.
  FirstPictures(int side, int rounds)
  {
    for (int round = 0; round < rounds; ++round)
    {
      for (const Policy::Kind way : Ways)
      {
        const auto values = RunInOwnProcess(
          { "patches", "first", std::to_string(static_cast<int>(way)), std::to_string(side) });
        if (values.size() == 2)
        {
          this->Seconds[way].push_back(values[0]);
          this->Bytes[way] = values[1];
        }
      }
    }
  }
  std::array<std::vector<double>, 3> Seconds;
  std::array<double, 3> Bytes{};
};
}

std::vector<double> MeasurePatchFirstPicture(const std::vector<std::string>& arguments)
{
  const auto grid = BenchmarkPatchMeshes::MakeHexahedra(std::atoi(arguments.at(1).c_str()));
  BenchmarkView view;
  view.LookAt(grid->GetBounds());
  const Stopwatch watch;
  const Policy way(static_cast<Policy::Kind>(std::atoi(arguments.at(0).c_str())), grid);
  view.AddActor(way.GetMapper());
  view.TimeFrame();
  return { watch.GetSeconds(), way.GetMemorySize() };
}

void AddPatchFrames(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("patches-frames",
    "Cubic hexahedra as patches, against vtkDataSetSurfaceFilter at level 4",
    { { "cells", "cells", 0 }, { "way", "way", 0 }, { "triangles", "triangles", 0 },
      { "first_ms", "first picture, ms", 0 }, { "ratio_first", "of level 4", 3 },
      { "frame_ms", "frame, ms", 1 }, { "ratio_frame", "of level 4", 3 },
      { "memory_mb", "memory, MB", 2 }, { "ratio_memory", "of level 4", 4 } });
  const int side = options.Quick ? 3 : 16;
  const FirstPictures first(side, options.Quick ? 1 : 5);
  const auto grid = BenchmarkPatchMeshes::MakeHexahedra(side);
  std::vector<std::unique_ptr<Policy>> ways;
  std::vector<vtkMapper*> mappers;
  for (const Policy::Kind way : Ways)
  {
    ways.push_back(std::make_unique<Policy>(way, grid));
    mappers.push_back(ways.back()->GetMapper());
  }
  BenchmarkView view;
  view.LookAt(grid->GetBounds());
  BenchmarkFrames frames(view, mappers);
  frames.Measure(options.Quick ? 2 : 15);
  for (const Policy::Kind way : Ways)
  {
    table.AddRow({ static_cast<double>(grid->GetNumberOfCells()), Policy::GetName(way),
      ways[way]->GetNumberOfTriangles(), 1e3 * GetMedian(first.Seconds[way]),
      GetMedianRatio(first.Seconds[way], first.Seconds[Policy::Even]), frames.GetMedian(way),
      frames.GetRatio(way, Policy::Even), 1e-6 * first.Bytes[way],
      first.Bytes[way] / first.Bytes[Policy::Even] });
  }
  table.AddNote(
    "1024 x 768, half a pixel, the camera moves with every frame. First pictures, each in a "
    "process "
    "of its own: from the grid in memory, filter and shaders included. Memory: what the filter "
    "puts "
    "out, and the mapper's buffers. Asked: first picture 0.3, frames 0.6, with exact scalars 1.0, "
    "memory 0.05.");
  addTable(table);
}
