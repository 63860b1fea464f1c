// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares volumes of cells with VTK's: frames, first pictures, edits and sorting.
#include "BenchmarkFrames.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumePictures.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeTasks.h"
#include "BenchmarkVolumeWay.h"
#include "Benchmarks.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkMeshVisibilitySort.h"

#include "vtkCellCenterDepthSort.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cstdio>
#include <functional>
#include <iostream>
#include <limits>

namespace
{
constexpr int Nodes = 11;
constexpr int ManyNodes = 255;
constexpr double Turn = 7.0; // degrees per frame

struct Effort
{
  int Size; // pixels per side of the picture
  int Rounds;
  int Minimum;
  double Seconds; // per mapper, as for BenchmarkFrames::Measure()
  int FirstPictures;
};

Effort GetEffort(const BenchmarkOptions& options)
{
  return options.Quick ? Effort{ 64, 1, 1, 1.0, 1 }
    : options.Full     ? Effort{ 512, 31, 9, 120.0, 9 }
                       : Effort{ 512, 7, 3, 8.0, 3 };
}

// A mesh and its functions.
struct Case
{
  Case(const BenchmarkVolumeScene& scene, BenchmarkVolumeScene::Split split)
    : Name(scene.GetName())
    , Mesh(scene.MakeMesh(split))
    , Property(scene.MakeProperty(this->Mesh, Nodes))
  {
  }

  std::string Name;
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkVolumeProperty> Property;
};

struct Pair
{
  double Milliseconds;
  double Against;
  double Ratio;
  double ProcessorRatio = std::numeric_limits<double>::quiet_NaN(); // only for frames
};

Pair GetPair(const BenchmarkFrames& frames, size_t prop, size_t against)
{
  return { frames.GetMedian(prop), frames.GetMedian(against), frames.GetRatio(prop, against),
    frames.GetProcessorRatio(prop, against) };
}

Pair GetPair(const std::vector<double>& seconds, const std::vector<double>& against)
{
  return { 1e3 * GetMedian(seconds), 1e3 * GetMedian(against), GetMedianRatio(seconds, against) };
}

void AddRow(BenchmarkTable& table, const Case& which, const std::string& measured,
  const std::string& against, const Pair& pair, double asked)
{
  table.AddRow({ which.Name, static_cast<double>(which.Mesh->GetNumberOfCells()), measured,
    pair.Milliseconds, against, pair.Against, pair.Ratio, pair.ProcessorRatio, asked });
}

// Adds frames of all ways that do not crash.
void AddFrames(
  const BenchmarkVolumeScene& scene, const Case& which, const Effort& effort, BenchmarkTable& table)
{
  enum
  {
    EXACT,
    MANY,
    PRE_INTEGRATED,
    PROJECTION,
    LINEAR,
    PROJECTED
  };
  const auto many = scene.MakeProperty(which.Mesh, ManyNodes);
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
  for (const VolumeWay way : { VolumeWay::Exact, VolumeWay::Exact, VolumeWay::PreIntegrated,
         VolumeWay::Projection, VolumeWay::VTKLinear, VolumeWay::VTKProjected })
  {
    volumes.push_back(MakeVolume(way, which.Mesh, which.Property));
  }
  volumes[MANY]->SetProperty(many);
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  BenchmarkFrames frames(view, std::vector<vtkProp*>(volumes.begin(), volumes.end()));
  frames.SetTurn(Turn);
  frames.Measure(effort.Rounds, effort.Minimum, effort.Seconds);
  auto add = [&](const char* measured, size_t one, const char* against, size_t other, double asked)
  { AddRow(table, which, measured, against, GetPair(frames, one, other), asked); };
  const char* exact = GetName(VolumeWay::Exact);
  const char* projected = GetName(VolumeWay::VTKProjected);
  add(exact, EXACT, GetName(VolumeWay::VTKLinear), LINEAR, 0.15);
  add(exact, EXACT, projected, PROJECTED, 0.5);
  add("exact, 255 nodes", MANY, GetName(VolumeWay::PreIntegrated), PRE_INTEGRATED, 2.5);
  add(GetName(VolumeWay::Projection), PROJECTION, projected, PROJECTED, 1.0);
}

// VTK's default integrator crashes for some meshes.
void AddDefault(const Case& which, BenchmarkVolumeScene::Split split,
  const BenchmarkOptions& options, BenchmarkTable& table)
{
  const auto result = RunInOwnProcess({ "volumes", "frames", which.Name, std::to_string(split),
    options.Quick    ? "quick"
      : options.Full ? "full"
                     : "" });
  if (result.size() == 4)
  {
    AddRow(table, which, GetName(VolumeWay::PreIntegrated), GetName(VolumeWay::VTKDefault),
      { result[0], result[1], result[2], result[3] }, 0.3);
  }
  else
  {
    table.AddNote(std::string(GetName(VolumeWay::VTKDefault)) + " crashed for " + which.Name +
      " of " + std::to_string(which.Mesh->GetNumberOfCells()) + " cells.");
  }
}

// From the mesh to the first frame, and to the second.
std::pair<double, double> TimeFirstFrames(VolumeWay way, const Case& which, int size)
{
  BenchmarkView view(size, size);
  view.LookAt(which.Mesh->GetBounds());
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->ShallowCopy(which.Mesh);
  const Stopwatch stopwatch;
  const auto volume = MakeVolume(way, mesh, which.Property);
  view.GetRenderer()->AddViewProp(volume);
  view.TimeFrame();
  const double first = stopwatch.GetSeconds();
  view.TimeFrame();
  return { first, stopwatch.GetSeconds() };
}

void AddFirstPictures(const Case& which, const Effort& effort, BenchmarkTable& table)
{
  std::vector<double> ours;
  std::vector<double> first;
  std::vector<double> second;
  for (int i = 0; i < effort.FirstPictures; ++i)
  {
    ours.push_back(TimeFirstFrames(VolumeWay::Exact, which, effort.Size).first);
    const auto theirs = TimeFirstFrames(VolumeWay::VTKProjected, which, effort.Size);
    first.push_back(theirs.first);
    second.push_back(theirs.second);
  }
  const std::string name = GetName(VolumeWay::VTKProjected);
  AddRow(table, which, "mesh to first picture", name + ", first frame", GetPair(ours, first), 1.0);
  AddRow(
    table, which, "mesh to first picture", name + ", second frame", GetPair(ours, second), 1.0);
}

double TimeSort(vtkVisibilitySort* sort)
{
  const Stopwatch stopwatch;
  sort->InitTraversal();
  while (sort->GetNextCells())
  {
  }
  return stopwatch.GetSeconds();
}

void AddSorts(const Case& which, const Effort& effort, BenchmarkTable& table)
{
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  vtkNew<vtkMeshVisibilitySort> ours;
  vtkNew<vtkCellCenterDepthSort> theirs;
  vtkVisibilitySort* const sorts[] = { ours, theirs };
  std::vector<double> seconds[2];
  for (vtkVisibilitySort* sort : sorts)
  {
    sort->SetInput(which.Mesh);
    sort->SetCamera(view.GetRenderer()->GetActiveCamera());
    sort->SetDirectionToBackToFront();
    sort->SetMaxCellsReturned(1000);
    TimeSort(sort); // computes what depends only on the mesh
  }
  for (int i = 0; i < effort.Rounds; ++i)
  {
    view.MoveCamera(Turn);
    for (int k = 0; k < 2; ++k)
    {
      seconds[k].push_back(TimeSort(sorts[k]));
    }
  }
  AddRow(table, which, "vtkMeshVisibilitySort", "vtkCellCenterDepthSort",
    GetPair(seconds[0], seconds[1]), 1.0);
}

// Frames after an edit and without one, in turn.
void AddEdits(
  const BenchmarkVolumeScene& scene, const Case& which, const Effort& effort, BenchmarkTable& table)
{
  const auto property = scene.MakeProperty(which.Mesh, Nodes);
  property->GetIsoSurfaceValues()->SetValue(0, scene.GetScalar(0.4));
  const auto volume = MakeVolume(VolumeWay::Exact, which.Mesh, property);
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  view.GetRenderer()->AddViewProp(volume);
  auto add = [&](const char* measured, const std::function<void(double)>& edit)
  {
    view.TimeFrame();
    std::vector<double> edited;
    std::vector<double> plain;
    for (int i = 0; i < effort.Rounds; ++i)
    {
      view.MoveCamera(Turn);
      plain.push_back(view.TimeFrame());
      const Stopwatch stopwatch;
      edit(0.3 + 0.01 * i);
      view.TimeFrame();
      edited.push_back(stopwatch.GetSeconds());
    }
    AddRow(table, which, measured, "the frame before", GetPair(edited, plain), 1.2);
  };
  add("edit of a function to picture",
    [&](double part) { BenchmarkVolumeScene::EditOpacity(property, part); });
  vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volume->GetMapper())->IsoSurfacesOn();
  add("edit of an isovalue to picture",
    [&](double part) { property->GetIsoSurfaceValues()->SetValue(0, scene.GetScalar(part)); });
}

// Hexahedra compared with their tetrahedra.
void AddUnsplit(const BenchmarkVolumeScene& scene, const Case& split, const Effort& effort,
  BenchmarkTable& table, BenchmarkTable& memory)
{
  const Case unsplit(scene, BenchmarkVolumeScene::UNSPLIT);
  // The same volume property for both.
  const vtkSmartPointer<vtkVolume> volumes[] = { MakeVolume(
                                                   VolumeWay::Exact, unsplit.Mesh, split.Property),
    MakeVolume(VolumeWay::Exact, split.Mesh, split.Property) };
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(split.Mesh->GetBounds());
  BenchmarkFrames frames(view, { volumes[0], volumes[1] });
  frames.SetTurn(Turn);
  frames.Measure(effort.Rounds, effort.Minimum, effort.Seconds);
  const std::string tetrahedra = std::to_string(split.Mesh->GetNumberOfCells()) + " tetrahedra";
  AddRow(table, unsplit, "hexahedra unsplit", tetrahedra, GetPair(frames, 0, 1), 1.3);
  double bytes[2];
  for (int i = 0; i < 2; ++i)
  {
    bytes[i] =
      static_cast<double>(vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volumes[i]->GetMapper())
                            ->GetGraphicsMemorySize());
  }
  memory.AddRow({ scene.GetName(), static_cast<double>(unsplit.Mesh->GetNumberOfCells()),
    1e-6 * bytes[0], tetrahedra, 1e-6 * bytes[1], bytes[0] / bytes[1], 0.8 });
}

// Published frames per second on a GeForce 6800 GT: lowest and highest.
struct Published
{
  const char* Scene;
  // Exact with 10 and with 255 linear segments, pre-integrated, and cell projection.
  const char* Frames[4];
};
const Published PublishedFrames[] = {
  { "grid 16", { "6.2-9.1", "2.0-5.8", "8.5-11.6", "14.5-21.3" } },
  { "grid 32", { "3.00-5.08", "1.71-3.30", "3.85-5.98", "3.42-3.74" } },
  { "fin", { "3.50-7.11", "2.98-5.04", "6.09-8.76", "3.09-3.50" } },
  { "post", { "2.32-4.21", "1.22-2.38", "3.40-5.91", "0.98-1.21" } },
};

std::string GetFramesPerSecond(const BenchmarkFrames& frames, size_t prop)
{
  char text[64];
  std::snprintf(
    text, sizeof(text), "%.2f-%.2f", 1e3 / frames.GetMaximum(prop), 1e3 / frames.GetMinimum(prop));
  return text;
}

void AddPublished(const Published& published, const Effort& effort, BenchmarkTable& table)
{
  const BenchmarkVolumeScene scene(published.Scene);
  if (scene.IsEmpty())
  {
    return;
  }
  std::cerr << "volumes: " << published.Scene << ", as published" << std::endl;
  const Case which(scene, BenchmarkVolumeScene::SIX);
  const auto ten = scene.MakeProperty(which.Mesh, 10);
  const auto many = scene.MakeProperty(which.Mesh, ManyNodes);
  const std::pair<VolumeWay, vtkVolumeProperty*> ways[] = { { VolumeWay::Exact, ten },
    { VolumeWay::Exact, many }, { VolumeWay::PreIntegrated, ten }, { VolumeWay::Projection, ten } };
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
  for (const auto& way : ways)
  {
    volumes.push_back(MakeVolume(way.first, which.Mesh, way.second));
  }
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  BenchmarkFrames frames(view, std::vector<vtkProp*>(volumes.begin(), volumes.end()));
  frames.SetTurn(360.0 / (effort.Rounds + 1));
  frames.Measure(effort.Rounds);
  for (size_t i = 0; i < volumes.size(); ++i)
  {
    table.AddRow({ which.Name, static_cast<double>(which.Mesh->GetNumberOfCells()),
      GetName(ways[i].first) +
        std::string(i == 0 ? ", 10 nodes"
            : i == 1       ? ", 255 nodes"
                           : ""),
      GetFramesPerSecond(frames, i), std::string(published.Frames[i]) });
  }
}

BenchmarkTable MakeTable()
{
  return BenchmarkTable("volumes", "Volumes of cells against VTK's",
    { { "mesh", "mesh", 0 }, { "cells", "cells", 0 }, { "measured", "measured", 0 },
      { "ms", "ms", 1 }, { "against", "against", 0 }, { "against_ms", "ms", 1 },
      { "ratio", "ratio", 3 }, { "ratio_processor", "of processor time", 3 },
      { "asked", "asked", 2 } });
}

void AddScene(const std::string& name, const BenchmarkOptions& options, BenchmarkTable& table,
  BenchmarkTable& memory)
{
  const BenchmarkVolumeScene scene(name);
  if (scene.IsEmpty())
  {
    table.AddNote("No " + name + ": RELEVO_TEST_DATA does not name its folder.");
    return;
  }
  const Effort effort = GetEffort(options);
  for (const auto split : { BenchmarkVolumeScene::FIVE, BenchmarkVolumeScene::SIX })
  {
    // The table of published figures already contains six.
    if (split == BenchmarkVolumeScene::SIX && !options.Full)
    {
      continue;
    }
    const Case which(scene, split);
    std::cerr << "volumes: " << name << ", " << which.Mesh->GetNumberOfCells() << " tetrahedra"
              << std::endl;
    AddFrames(scene, which, effort, table);
    AddDefault(which, split, options, table);
    AddFirstPictures(which, effort, table);
    AddSorts(which, effort, table);
    if (split == BenchmarkVolumeScene::FIVE)
    {
      AddEdits(scene, which, effort, table);
      AddUnsplit(scene, which, effort, table, memory);
    }
  }
}
}

// picture SCENE SIZE -> see MeasureVolumePicture()
// memory SCENE HOST -> see MeasureVolumeMemory()
// frames SCENE SPLIT quick|full|"" -> milliseconds pre-integrated and of VTK's default integrator,
// and their ratios
std::vector<double> MeasureVolumes(const std::vector<std::string>& arguments)
{
  if (arguments.at(0) == "picture")
  {
    return MeasureVolumePicture({ arguments.begin() + 1, arguments.end() });
  }
  if (arguments.at(0) == "memory")
  {
    return MeasureVolumeMemory({ arguments.begin() + 1, arguments.end() });
  }
  const BenchmarkVolumeScene scene(arguments.at(1));
  const Case which(scene, static_cast<BenchmarkVolumeScene::Split>(std::stoi(arguments.at(2))));
  BenchmarkOptions options;
  options.Quick = arguments.at(3) == "quick";
  options.Full = arguments.at(3) == "full";
  const Effort effort = GetEffort(options);
  const auto ours = MakeVolume(VolumeWay::PreIntegrated, which.Mesh, which.Property);
  const auto theirs = MakeVolume(VolumeWay::VTKDefault, which.Mesh, which.Property);
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  BenchmarkFrames frames(view, { ours, theirs });
  frames.SetTurn(Turn);
  frames.Measure(effort.Rounds, effort.Minimum, effort.Seconds);
  const Pair pair = GetPair(frames, 0, 1);
  return { pair.Milliseconds, pair.Against, pair.Ratio, pair.ProcessorRatio };
}

void RunVolumes(const BenchmarkOptions& options, const AddTable& addTable)
{
  const Effort effort = GetEffort(options);
  AddVolumePictures(options, addTable);

  BenchmarkTable published("volumes-published",
    "Frames a second of volumes, slowest and fastest around the mesh",
    { { "mesh", "mesh", 0 }, { "cells", "tetrahedra", 0 }, { "way", "way", 0 },
      { "frames_per_second", "here", 0 }, { "published", "published", 0 } });
  for (const Published& each : PublishedFrames)
  {
    if (!options.Quick || each.Scene == PublishedFrames[0].Scene)
    {
      AddPublished(each, effort, published);
    }
  }
  published.AddNote(
    "Published: 512 x 512 pixels on a GeForce 6800 GT (R. Espinha, PUC-Rio, 2005), "
    "for its own transfer functions: ratios of rows can be compared, not machines.");
  addTable(published);

  BenchmarkTable table = MakeTable();
  BenchmarkTable memory("volumes-memory", "Graphics memory of hexahedra unsplit",
    { { "mesh", "mesh", 0 }, { "cells", "hexahedra", 0 }, { "mb", "MB", 2 },
      { "against", "against", 0 }, { "against_mb", "MB", 2 }, { "ratio", "ratio", 3 },
      { "asked", "asked", 1 } });
  const bool hasData = !options.Quick && !BenchmarkVolumeScene("fin").IsEmpty();
  const std::vector<std::string> names = hasData ? std::vector<std::string>{ "fin", "post" }
    : options.Quick                              ? std::vector<std::string>{ "bent 6" }
                                                 : std::vector<std::string>{ "bent 32" };
  for (const std::string& name : names)
  {
    AddScene(name, options, table, memory);
  }
  table.AddNote(std::to_string(effort.Size) + " x " + std::to_string(effort.Size) +
    " pixels, the camera turns, frames in turn; ratios are medians. Functions of 11 nodes. The "
    "first frame of vtkProjectedTetrahedraMapper lacks up to 1000 cells. Sorts without what "
    "depends on the mesh alone.");
  addTable(table);
  addTable(memory);
}
