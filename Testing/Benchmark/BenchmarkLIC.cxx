// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures line integral convolution on surfaces: cost and quality, compared with the surface LIC
// of ParaView's VTK if it is available.
#include "BenchmarkFlow.h"
#include "BenchmarkLICContest.h"
#include "BenchmarkLICPicture.h"
#include "BenchmarkLICRival.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLICNoiseSource.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <iostream>
#include <map>

namespace
{
using Contest = BenchmarkLICContest;

// The frames of each way, one per round.
class Rounds
{
public:
  void Add(Contest::Policy way, const LICFrame& frame) { this->Frames[way].push_back(frame); }

  double GetMedian(Contest::Policy way) const
  {
    std::vector<double> times;
    for (const LICFrame& frame : this->Frames.at(way))
    {
      times.push_back(frame.Milliseconds);
    }
    return ::GetMedian(times);
  }

  // The difference between two ways, round by round.
  std::vector<double> Subtract(
    Contest::Policy way, Contest::Policy other, double LICFrame::*figure) const
  {
    std::vector<double> differences;
    for (size_t i = 0; i < this->Frames.at(way).size(); ++i)
    {
      differences.push_back(this->Frames.at(way)[i].*figure - this->Frames.at(other)[i].*figure);
    }
    return differences;
  }

  // The ratio to VTK of the whole LIC: the frame time minus that without LIC.
  double GetRatio(double LICFrame::*figure) const
  {
    return GetMedianRatio(this->Subtract(Contest::LIC, Contest::PLAIN, figure),
      this->Subtract(Contest::VTK_LIC, Contest::VTK_PLAIN, figure));
  }

  // The convolution is proportional to the number of steps. With one step, the two passes still
  // take two of them.
  std::vector<double> GetConvolutions(double LICFrame::*figure) const
  {
    const int steps = LICSettings().NumberOfSteps + LICSettings().NumberOfSteps / 2;
    auto convolutions = this->Subtract(Contest::LIC, Contest::LIC_SHORT, figure);
    for (double& convolution : convolutions)
    {
      convolution *= steps / (steps - 2.0);
    }
    return convolutions;
  }

  // The share of the LIC without the convolution in the frame, in processor time.
  double GetRestPercent() const
  {
    const auto whole = this->Subtract(Contest::LIC, Contest::PLAIN, &LICFrame::Processor);
    const auto convolution = this->GetConvolutions(&LICFrame::Processor);
    std::vector<double> percents;
    for (size_t i = 0; i < whole.size(); ++i)
    {
      percents.push_back(
        100.0 * (whole[i] - convolution[i]) / this->Frames.at(Contest::LIC)[i].Processor);
    }
    return ::GetMedian(percents);
  }

private:
  std::map<Contest::Policy, std::vector<LICFrame>> Frames;
};

struct Tables
{
  BenchmarkTable Frames{ "lic-frames",
    "Line integral convolution on surfaces, milliseconds a frame",
    { { "scene", "scene", 0 }, { "triangles", "triangles", 0 }, { "plain_ms", "without LIC", 0 },
      { "moving_ms", "the camera moves", 0 }, { "still_ms", "the camera stands", 0 },
      { "convolution_ms", "convolution alone", 0 },
      { "rest_percent", "rest of the LIC, % of the frame", 0 } } };
  BenchmarkTable Against{ "lic-vtk", "VTK's surface LIC, milliseconds a frame",
    { { "scene", "scene", 0 }, { "plain_ms", "without LIC", 0 },
      { "moving_ms", "the camera moves", 0 }, { "still_ms", "the camera stands", 0 },
      { "ratio", "Relevo's LIC alone / VTK's", 2 },
      { "ratio_processor", "of processor time", 2 } } };
  BenchmarkTable Pictures{ "lic-pictures",
    "The grey of the LIC, and the angle between its lines and the field",
    { { "scene", "scene", 0 }, { "settings", "settings", 0 }, { "by", "drawn by", 0 },
      { "mean", "mean", 4 }, { "deviation", "standard deviation", 4 },
      { "angle_median", "median angle, degrees", 2 },
      { "angle_95", "95th percentile, degrees", 2 } } };
};

void MeasureFrames(
  const FlowScene& scene, const BenchmarkOptions& options, vtkImageData* noise, Tables& tables)
{
  std::cerr << "lic: frames of " << scene.Name << std::endl;
  Contest contest(options, scene, noise, LICSettings(), LICSettings());
  if (scene.GetDirection)
  {
    FlowScene::LookAlongZ(contest.GetCamera());
  }
  else
  {
    contest.GetView().LookAt(scene.Mesh->GetBounds());
  }
  std::vector<Contest::Policy> ways = { Contest::LIC, Contest::LIC_SHORT, Contest::PLAIN };
  const bool hasRival = !contest.GetRival().GetRenderer().empty();
  if (hasRival)
  {
    ways.insert(ways.end(), { Contest::VTK_LIC, Contest::VTK_PLAIN });
  }
  for (const Contest::Policy way : ways)
  {
    contest.Draw(way); // warms up
  }
  Rounds moving;
  Rounds still;
  const int rounds = options.Quick ? 1 : options.Full ? 31 : 5;
  for (int round = 0; round < rounds; ++round)
  {
    contest.GetView().MoveCamera();
    for (size_t i = 0; i < ways.size(); ++i)
    {
      const Contest::Policy way = ways[(i + round) % ways.size()];
      moving.Add(way, contest.Draw(way));
      if (way == Contest::LIC || way == Contest::VTK_LIC)
      {
        still.Add(way, contest.Draw(way));
      }
    }
  }
  tables.Frames.AddRow({ scene.Name, static_cast<double>(scene.Mesh->GetNumberOfPolys()),
    moving.GetMedian(Contest::PLAIN), moving.GetMedian(Contest::LIC), still.GetMedian(Contest::LIC),
    GetMedian(moving.GetConvolutions(&LICFrame::Milliseconds)), moving.GetRestPercent() });
  if (hasRival)
  {
    tables.Against.AddRow({ scene.Name, moving.GetMedian(Contest::VTK_PLAIN),
      moving.GetMedian(Contest::VTK_LIC), still.GetMedian(Contest::VTK_LIC),
      moving.GetRatio(&LICFrame::Milliseconds), moving.GetRatio(&LICFrame::Processor) });
  }
}

// The settings for both.
struct Setup
{
  const char* Name = "";
  bool HasNoise = true; // if both get the same noise; otherwise each uses its default
  LICSettings Ours = {};
  LICSettings VTKs = {};
};

std::vector<Setup> MakeSetups()
{
  // VTK's step has the length sqrt(1 / width^2 + 1 / height^2) in texture coordinates, in which it
  // normalizes the vectors: 1.25 to 1.67 pixels in a window of 4 to 3.
  const double longStep = 1.45;
  LICSettings onePass;
  onePass.EnhancedLIC = 0;
  LICSettings longSteps;
  longSteps.StepSize = longStep;
  LICSettings longOnePass = onePass;
  longOnePass.StepSize = longStep;
  LICSettings contrast;
  contrast.EnhanceContrast = 1;
  LICSettings smooth;
  smooth.AntiAlias = 1;
  return { { "the same noise" }, { "each its own noise", false },
    { "lines of equal length", true, longSteps }, { "one pass", true, onePass, onePass },
    { "one pass, lines of equal length", true, longOnePass, onePass },
    { "contrast enhanced", true, contrast, contrast },
    { "one pass of anti-aliasing", true, smooth, smooth } };
}

void MeasurePicture(const FlowScene& scene, const Setup& setup, const BenchmarkOptions& options,
  vtkImageData* noise, Tables& tables)
{
  std::cerr << "lic: picture of " << scene.Name << ", " << setup.Name << std::endl;
  Contest contest(options, scene, setup.HasNoise ? noise : nullptr, setup.Ours, setup.VTKs);
  FlowScene::LookAlongZ(contest.GetCamera());
  BenchmarkView& view = contest.GetView();
  const auto addRow = [&](const char* by, const std::vector<unsigned char>& picture)
  {
    std::vector<BenchmarkTable::Value> row = { scene.Name, std::string(setup.Name),
      std::string(by) };
    const std::vector<double> figures =
      GetPictureFigures(scene, view.GetWidth(), view.GetHeight(), picture);
    row.insert(row.end(), figures.begin(), figures.end());
    tables.Pictures.AddRow(row);
  };
  contest.Draw(Contest::LIC);
  addRow("Relevo", view.GetPicture());
  if (!contest.GetRival().GetRenderer().empty())
  {
    contest.Draw(Contest::VTK_LIC);
    addRow("VTK", contest.GetRival().GetPicture());
  }
}

// noise.png of RELEVO_TEST_DATA, or else our noise as grey bytes, so that a file can store it
// exactly.
vtkSmartPointer<vtkImageData> MakeNoise()
{
  auto noise = vtkSmartPointer<vtkImageData>::New();
  const std::string fileName = BenchmarkFlow::FindFile("noise.png");
  if (!fileName.empty())
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(fileName.c_str());
    reader->Update();
    noise->ShallowCopy(reader->GetOutput());
    return noise;
  }
  vtkNew<vtkLICNoiseSource> source;
  source->Update();
  noise->CopyStructure(source->GetOutput());
  noise->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    noise->GetPointData()->GetScalars()->SetComponent(
      i, 0, std::round(255.0 * values->GetComponent(i, 0)));
  }
  return noise;
}

std::string GetRivalNote(const BenchmarkOptions& options)
{
  if (options.ParaView.empty())
  {
    return "VTK's surface LIC is left out without --paraview PREFIX, see "
           "Testing/Benchmark/ParaView/fetch.sh.";
  }
  const FlowScene scene = BenchmarkFlow::MakeVortex(1);
  const std::string renderer =
    BenchmarkLICRival(options, scene.Mesh, 16, 16, nullptr, LICSettings()).GetRenderer();
  return renderer.empty() ? "The VTK of " + options.ParaView + " does not run."
                          : "VTK: ParaView's vtkSurfaceLICMapper on " + renderer + '.';
}
}

void RunLIC(const BenchmarkOptions& options, const AddTable& addTable)
{
  const auto noise = MakeNoise();
  const int resolution = options.Quick ? 20 : 400;
  std::vector<FlowScene> scenes = { BenchmarkFlow::MakeVortex(resolution) };
  if (!options.Quick)
  {
    scenes.push_back(BenchmarkFlow::MakeSphere(resolution / 2));
    scenes.push_back(BenchmarkFlow::MakeTorus(resolution / 2));
  }
  std::vector<FlowScene> timed = scenes;
  std::vector<FlowScene> compared = scenes;
  if (!options.Quick)
  {
    timed.push_back(BenchmarkFlow::MakeVortex(10));
    timed.back().Name = "vortex, few triangles";
    const auto files = BenchmarkFlow::ReadScenes();
    timed.insert(timed.end(), files.begin(), files.end());
    compared.push_back(BenchmarkFlow::MakeUniform(resolution));
    compared.push_back(BenchmarkFlow::MakeSaddle(resolution));
    compared.push_back(BenchmarkFlow::MakeDipole(resolution));
  }

  Tables tables;
  for (const FlowScene& scene : timed)
  {
    MeasureFrames(scene, options, noise, tables);
  }
  const std::string rival = GetRivalNote(options);
  tables.Frames.AddNote("20 steps of 1 each way, two passes, no refinement; medians. Convolution: "
                        "from what a frame of one step takes less. Rest: what the LIC takes beside "
                        "it, in processor time. " +
    rival);
  addTable(tables.Frames);
  if (tables.Against.GetNumberOfRows() > 0)
  {
    tables.Against.AddNote("At the same settings, drawn in turn. LIC alone: the frame less the one "
                           "without LIC.");
    addTable(tables.Against);
  }
  for (const FlowScene& scene : compared)
  {
    const bool isFirst = &scene == &compared.front();
    for (const Setup& setup : MakeSetups())
    {
      // Measures all settings for the first scene, and the defaults for the others.
      if (isFirst || !setup.HasNoise)
      {
        MeasurePicture(scene, setup, options, noise, tables);
      }
    }
  }
  tables.Pictures.AddNote(
    "Seen along the z axis, unlit. Lines by the structure tensor: derivatives of a Gaussian of 1 "
    "pixel, smoothed by one of 3. What is close to borders, outlines and singular points does not "
    "count. " +
    rival);
  addTable(tables.Pictures);
}
