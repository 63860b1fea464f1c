// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeWay.h"
#include "Benchmarks.h"

#include "vtkVolumeRayCastFilter.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <iostream>

namespace
{
constexpr double TwinTurn = 7.0; // degrees per frame
constexpr int TwinNodes = 11;

// Processor seconds of the filter and of the mapper, in turn.
struct TwinSeconds
{
  std::vector<double> Casting; // the filter's next picture of the same mesh
  std::vector<double> Frames;  // of the mapper
  double First = 0.0;          // with reading the mesh
  double FirstFrame = 0.0;
};

TwinSeconds TimeTwin(vtkUnstructuredGrid* mesh, vtkVolumeProperty* property, int size, int rounds)
{
  TwinSeconds seconds;
  const auto time = [](const auto& work)
  {
    const double begin = GetProcessorSeconds();
    work();
    return GetProcessorSeconds() - begin;
  };
  BenchmarkView view(size, size);
  view.LookAt(mesh->GetBounds());
  view.TimeFrame();
  const auto volume = MakeVolume(VolumeWay::Exact, mesh, property);
  view.GetRenderer()->AddViewProp(volume);
  seconds.FirstFrame = time([&] { view.TimeFrame(); });
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetCamera(view.GetRenderer()->GetActiveCamera());
  filter->SetViewportSize(size, size);
  filter->SetVolumeProperty(property);
  seconds.First = time([&] { filter->Update(); });
  for (int round = 0; round < rounds; ++round)
  {
    view.MoveCamera(TwinTurn);
    seconds.Frames.push_back(time([&] { view.TimeFrame(); }));
    seconds.Casting.push_back(time([&] { filter->Update(); }));
  }
  return seconds;
}
}

void RunVolumeTwin(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("volumes-twin",
    "Processor time of vtkVolumeRayCastFilter against vtkGPUUnstructuredGridVolumeMapper",
    { { "mesh", "mesh", 0 }, { "cells", "cells", 0 }, { "kind", "kind", 0 },
      { "ms", "filter, ms", 0 }, { "frame_ms", "mapper's frame, ms", 0 }, { "ratio", "ratio", 2 },
      { "asked", "asked", 0 }, { "first_ms", "filter with reading, ms", 0 },
      { "first_frame_ms", "mapper's first frame, ms", 0 }, { "ratio_first", "ratio", 2 } });
  const int size = options.Quick ? 64 : 512;
  const int rounds = options.Quick ? 1 : options.Full ? 9 : 3;
  const std::vector<std::string> names = options.Quick
    ? std::vector<std::string>{ "bent 6" }
    : std::vector<std::string>{ "bent 32", "fin" };
  for (const std::string& name : names)
  {
    const BenchmarkVolumeScene scene(name);
    if (scene.IsEmpty())
    {
      table.AddNote("No " + name + ": RELEVO_TEST_DATA does not name its folder.");
      continue;
    }
    for (const auto split : { BenchmarkVolumeScene::SIX, BenchmarkVolumeScene::UNSPLIT })
    {
      const auto mesh = scene.MakeMesh(split);
      const auto property = scene.MakeProperty(mesh, TwinNodes);
      const TwinSeconds seconds = TimeTwin(mesh, property, size, rounds);
      const double ratio = GetMedianRatio(seconds.Casting, seconds.Frames);
      std::cerr << "volumes: " << name << ", filter against mapper: " << ratio << ", with reading "
                << seconds.First / seconds.FirstFrame << std::endl;
      table.AddRow({ name, static_cast<double>(mesh->GetNumberOfCells()),
        std::string(split == BenchmarkVolumeScene::SIX ? "tetrahedra" : "hexahedra"),
        1e3 * GetMedian(seconds.Casting), 1e3 * GetMedian(seconds.Frames), ratio, 3.0,
        1e3 * seconds.First, 1e3 * seconds.FirstFrame, seconds.First / seconds.FirstFrame });
    }
  }
  table.AddNote(std::to_string(size) + " x " + std::to_string(size) +
    " pixels, the camera turns, in turn; ratios are medians. Processor time of all cores. The "
    "mapper's first frame includes building its shaders.");
  addTable(table);
}
