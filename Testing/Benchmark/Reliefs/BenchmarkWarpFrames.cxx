// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkWarpFrames.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkWarpSamples.h"
#include "Data/Relief.h"
#include "vtkReliefWarper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <iostream>
#include <limits>
#include <string>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Step = 0.02;

struct Speed
{
  double Frames; // per second
  double Warps;
};

class WarpedQuad
{
public:
  WarpedQuad(vtkImageData* relief, int size, int policy)
    : Size(size)
    , View(400, 300)
  {
    this->Warper->SetInputData(relief);
    this->Warper->SetCamera(this->Camera);
    this->Warper->SetPolicy(policy);
    vtkNew<vtkPlaneSource> plane;
    plane->SetPoint1(size - 1.0, 0.0, 0.0);
    plane->SetPoint2(0.0, size - 1.0, 0.0);
    plane->SetOrigin(0.0, 0.0, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    const auto actor = this->View.AddActor(mapper);
    this->Texture->SetInputData(this->Picture);
    actor->SetTexture(this->Texture);
    actor->GetProperty()->LightingOff();
    this->View.GetRenderer()->SetActiveCamera(this->Camera);
  }

  void Draw()
  {
    MoveCamera(this->Camera, this->Size, Step * ++this->Number);
    this->Warper->Update();
    if (this->Warper->GetNumberOfWarps() != this->Shown)
    {
      this->Shown = this->Warper->GetNumberOfWarps();
      this->Picture->ShallowCopy(this->Warper->GetOutput());
      this->Picture->GetPointData()->SetActiveScalars(relevo::Relief::GetColorName());
    }
    this->View.TimeFrame();
  }

  // Draws frames for this many seconds.
  Speed Measure(double seconds)
  {
    const auto warps = this->Warper->GetNumberOfWarps();
    const Stopwatch stopwatch;
    double frames = 0.0;
    while (stopwatch.GetSeconds() < seconds)
    {
      this->Draw();
      ++frames;
    }
    const double taken = stopwatch.GetSeconds();
    return { frames / taken, (this->Warper->GetNumberOfWarps() - warps) / taken };
  }

private:
  const int Size;
  BenchmarkView View;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkReliefWarper> Warper;
  vtkNew<vtkImageData> Picture;
  vtkNew<vtkTexture> Texture;
  int Number = 0;
  vtkIdType Shown = -1;
};

const char* const Names[] = { "sequential", "parallel", "multi-threaded" };
constexpr int Policies[] = { vtkReliefWarper::SEQUENTIAL, vtkReliefWarper::PARALLEL,
  vtkReliefWarper::MULTI_THREADED };

void AddSample(
  const BenchmarkWarpSample& sample, int size, int rounds, double seconds, BenchmarkTable& table)
{
  const auto relief = MakeRelief(sample, size);
  std::vector<double> frames[3];
  std::vector<double> warps[3];
  for (int round = 0; round < rounds; ++round)
  {
    for (int policy = 0; policy < 3; ++policy)
    {
      WarpedQuad quad(relief, size, Policies[policy]);
      quad.Draw(); // the first frame reads the relief
      const Speed speed = quad.Measure(seconds);
      frames[policy].push_back(speed.Frames);
      warps[policy].push_back(speed.Warps);
    }
  }
  for (int policy = 0; policy < 3; ++policy)
  {
    const bool isAsked = policy == 1 && size == 1024;
    table.AddRow({ std::string(sample.Name), static_cast<double>(size), std::string(Names[policy]),
      GetMedian(frames[policy]), GetMedian(warps[policy]),
      GetMedianRatio(frames[policy], frames[0]), isAsked ? 1.5 : NaN,
      GetMedianRatio(warps[policy], warps[0]), isAsked ? 0.9 : NaN });
  }
}
}

void AddWarpFrames(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("relief-warp-frames",
    "Frames of the warped picture on one quad, 400 x 300 pixels, while the camera moves",
    { { "sample", "sample", 0 }, { "texels", "texels a side", 0 }, { "policy", "policy", 0 },
      { "frames", "frames/s", 1 }, { "warps", "warps/s", 1 },
      { "ratio_frames", "frames to sequential's", 2 }, { "ratio_frames_asked", "asked", 1 },
      { "ratio_warps", "warps to sequential's", 2 }, { "ratio_warps_asked", "asked", 1 } });
  for (const BenchmarkWarpSample& sample : GetWarpSamples())
  {
    for (int size : { 256, 1024 })
    {
      if (options.Quick && size > 256)
      {
        continue;
      }
      std::cerr << "relief: frames of " << sample.Name << ", " << size << std::endl;
      AddSample(sample, size, options.Quick ? 1 : 3, options.Quick ? 0.2 : 2.0, table);
    }
  }
  table.AddNote(
    "Sequential's and multi-threaded frames each wait for their warp. Without a graphics "
    "card the frames take the processor from the worker.");
  addTable(table);
}
