// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeWay.h"
#include "Benchmarks.h"
#include "Mathematics/PictureSimilarity.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

namespace
{
constexpr double DetailTurn = 7.0; // degrees per frame
constexpr double DetailShare = 0.1;
constexpr double LongestBuild = 300.0; // seconds: then the benchmark gives up

struct DetailFrames
{
  std::vector<double> Full;
  std::vector<double> Moving;
  double Similarity = 1.0; // the least
};

// Moving and still frames of the same views in turn.
DetailFrames Compare(BenchmarkView& view, int rounds)
{
  vtkRenderWindow* window = view.GetRenderer()->GetRenderWindow();
  DetailFrames frames;
  for (int round = -1; round < rounds; ++round)
  {
    view.MoveCamera(DetailTurn);
    double seconds[2];
    std::vector<unsigned char> pictures[2];
    for (int i = 0; i < 2; ++i)
    {
      window->SetDesiredUpdateRate(i == 0 ? 0.0 : 15.0);
      seconds[i] = view.TimeFrame();
      pictures[i] = view.GetPicture();
    }
    if (round >= 0)
    {
      frames.Full.push_back(seconds[0]);
      frames.Moving.push_back(seconds[1]);
      frames.Similarity = std::min(frames.Similarity,
        relevo::GetPictureSimilarity(pictures[0], pictures[1], view.GetWidth(), view.GetHeight()));
    }
  }
  window->SetDesiredUpdateRate(0.0);
  return frames;
}

void AddDetail(const std::string& name, int nodes, int size, int rounds, BenchmarkTable& table)
{
  const BenchmarkVolumeScene scene(name);
  const auto mesh = scene.MakeMesh(BenchmarkVolumeScene::SIX);
  const auto volume = MakeVolume(VolumeWay::Exact, mesh, scene.MakeProperty(mesh, nodes));
  auto* mapper = vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volume->GetMapper());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetLevelOfDetail(DetailShare);
  BenchmarkView view(size, size);
  view.LookAt(mesh->GetBounds());
  view.GetRenderer()->AddViewProp(volume);
  view.TimeFrame();
  const Stopwatch stopwatch;
  while (mapper->GetNumberOfLevelOfDetailCells() == 0 && stopwatch.GetSeconds() < LongestBuild)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const double build = stopwatch.GetSeconds();
  const DetailFrames frames = Compare(view, rounds);
  double range[2];
  mesh->GetScalarRange(range);
  std::cerr << "volumes: level of detail: " << GetMedianRatio(frames.Moving, frames.Full) << ", "
            << frames.Similarity << std::endl;
  table.AddRow({ static_cast<double>(mesh->GetNumberOfCells()),
    static_cast<double>(mapper->GetNumberOfLevelOfDetailCells()), static_cast<double>(nodes),
    1e3 * GetMedian(frames.Full), 1e3 * GetMedian(frames.Moving),
    GetMedianRatio(frames.Moving, frames.Full), 0.5, frames.Similarity, 0.98,
    mapper->GetLevelOfDetailError() / (range[1] - range[0]), build });
}
}

void RunVolumeDetail(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("volumes-detail", "Moving views of a tenth of the cells",
    { { "cells", "tetrahedra", 0 }, { "simple", "simplified", 0 }, { "nodes", "nodes", 0 },
      { "full_ms", "full, ms", 1 }, { "moving_ms", "moving, ms", 1 }, { "ratio", "ratio", 3 },
      { "asked", "asked", 2 }, { "ssim", "SSIM", 4 }, { "ssim_asked", "asked", 2 },
      { "error", "error, share of the range", 4 }, { "build_s", "in the background, s", 1 } });
  const std::string name = options.Quick ? "grid 8" : "grid 55";
  const int size = options.Quick ? 64 : 512;
  for (const int nodes : { 2, 11 })
  {
    AddDetail(name, nodes, size, options.Quick ? 1 : 3, table);
  }
  table.AddNote(std::to_string(size) + " x " + std::to_string(size) +
    " pixels, still and moving frames of the same views in turn; ratios are medians, SSIM the "
    "least of all views, in windows of 7 x 7 pixels.");
  addTable(table);
}
