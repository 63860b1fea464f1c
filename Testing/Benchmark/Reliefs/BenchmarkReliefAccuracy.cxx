// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReliefAccuracy.h"

#include "BenchmarkPixelPoints.h"
#include "BenchmarkReliefWay.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkWarpSamples.h"
#include "RelevoReliefRays.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{
using RelevoVectors::Vector;
using RelevoVectors::operator-;

struct Shares
{
  double Right = 0.0;  // share of the pixels that rays hit
  double Missed = 0.0; // share of these
  double Extra = 0.0;  // pixels without a hit, relative to these
};

Shares Compare(const RelevoReliefRays& rays, const std::vector<RelevoReliefHit>& hits,
  const BenchmarkPixelPoints& pixels, const std::vector<float>& depths)
{
  Shares shares;
  double number = 0.0;
  for (int i = 0; i < pixels.GetNumberOfPixels(); ++i)
  {
    const bool isDrawn = depths[i] < 1.0f;
    number += hits[i].IsHit;
    shares.Missed += hits[i].IsHit && !isDrawn;
    shares.Extra += !hits[i].IsHit && isDrawn;
    if (hits[i].IsHit && isDrawn)
    {
      const auto texel = rays.Find(pixels.Get(i, depths[i]));
      shares.Right += std::hypot(texel[0] - hits[i].Column, texel[1] - hits[i].Row) <= 0.5;
    }
  }
  return { shares.Right / number, shares.Missed / number, shares.Extra / number };
}

void AddSample(const BenchmarkWarpSample& sample, int size, BenchmarkView& view, double step,
  BenchmarkTable& table)
{
  const auto relief = MakeRelief(sample, size);
  const RelevoReliefRays rays(relief);
  std::vector<RelevoReliefHit> hits;
  for (const ReliefWay way : GetReliefWays())
  {
    const auto actor = MakeReliefActor(way, relief);
    view.GetRenderer()->AddActor(actor);
    MoveCamera(view.GetRenderer()->GetActiveCamera(), size, step);
    view.TimeFrame();
    view.TimeFrame();
    const BenchmarkPixelPoints pixels(view);
    for (int i = static_cast<int>(hits.size()); i < pixels.GetNumberOfPixels(); ++i)
    {
      const Vector near = pixels.Get(i, 0.0);
      hits.push_back(rays.Cast(near, pixels.Get(i, 1.0) - near, 0.0, 1.0));
    }
    const Shares shares = Compare(rays, hits, pixels, view.GetDepths());
    view.GetRenderer()->RemoveActor(actor);
    table.AddRow({ std::string(sample.Name), std::string(GetName(way)), 100.0 * shares.Right,
      100.0 * shares.Missed, 100.0 * shares.Extra });
  }
}
}

void AddReliefAccuracy(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("relief-accuracy", "Pixels of reliefs against rays in double precision",
    { { "sample", "sample", 0 }, { "way", "drawn by", 0 },
      { "right_percent", "within half a texel, %", 2 }, { "missed_percent", "missed, %", 2 },
      { "extra_percent", "beside the surface, %", 2 } });
  const int size = options.Quick ? 32 : 96;
  BenchmarkView view(options.Quick ? 64 : 240, options.Quick ? 48 : 180);
  for (const BenchmarkWarpSample& sample : GetWarpSamples())
  {
    std::cerr << "relief: accuracy, " << sample.Name << std::endl;
    AddSample(sample, size, view, 1.0, table);
  }
  table.AddNote("Of the pixels that the rays hit. Asked: 99.9 % by rays with the maximum mipmap.");
  addTable(table);
}
