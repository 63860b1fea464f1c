// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkVolumeTasks.h"

#include "BenchmarkAllocations.h"
#include "BenchmarkFrames.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeWay.h"
#include "Benchmarks.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"

#include "vtkActor.h"
#include "vtkContourFilter.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <thread>

namespace
{
constexpr double TaskTurn = 7.0;    // degrees per frame
constexpr double MostOfDrag = 10.0; // times its duration: then the benchmark gives up

struct TaskCase
{
  explicit TaskCase(const std::string& name)
    : Scene(name)
    , Mesh(Scene.MakeMesh(BenchmarkVolumeScene::UNSPLIT))
  {
  }

  BenchmarkVolumeScene Scene;
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
};

struct TaskEffort
{
  std::string Scene;
  int Size;      // pixels per side of the picture
  int LargeSize; // also for isosurfaces alone and opacities
  int Rounds;
  std::vector<std::string> MemoryScenes;
};

TaskEffort GetTaskEffort(const BenchmarkOptions& options)
{
  return options.Quick ? TaskEffort{ "bent 6", 64, 64, 1, { "bent 6" } }
                       : TaskEffort{ "bent 100", options.Full ? 512 : 256, 512,
                           options.Full ? 9 : 3, { "bent 100", "bent 171" } };
}

vtkGPUUnstructuredGridVolumeMapper* GetMapper(vtkVolume* volume)
{
  return vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volume->GetMapper());
}

// Props that are removed would lose their buffers.
void ShowAlone(BenchmarkView& view, vtkProp* shown)
{
  vtkPropCollection* props = view.GetRenderer()->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    prop->SetVisibility(prop == shown);
  }
  if (!view.GetRenderer()->HasViewProp(shown))
  {
    view.GetRenderer()->AddViewProp(shown);
  }
}

class TaskTable
{
public:
  TaskTable(const TaskCase& which, BenchmarkTable& table)
    : Which(which)
    , Table(table)
  {
  }
  void Add(const std::string& measured, const std::vector<double>& seconds,
    const std::string& against, const std::vector<double>& reference, double asked)
  {
    std::cerr << measured << ": " << GetMedianRatio(seconds, reference) << std::endl;
    this->Table.AddRow({ static_cast<double>(this->Which.Mesh->GetNumberOfCells()), measured,
      1e3 * GetMedian(seconds), against, 1e3 * GetMedian(reference),
      GetMedianRatio(seconds, reference), asked });
  }

private:
  const TaskCase& Which;
  BenchmarkTable& Table;
};

vtkSmartPointer<vtkVolumeProperty> MakeSurfaces(const TaskCase& which)
{
  auto property = which.Scene.MakeProperty(which.Mesh, 11);
  property->GetIsoSurfaceValues()->SetValue(0, which.Scene.GetScalar(0.5));
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(which.Scene.GetScalar(0.0), 1.0);
  return property;
}

// Opaque only in a tenth of the range.
vtkSmartPointer<vtkVolumeProperty> MakePeak(const TaskCase& which)
{
  auto property = which.Scene.MakeProperty(which.Mesh, 11);
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(which.Scene.GetScalar(0.45), 0.0);
  opacity->AddPoint(which.Scene.GetScalar(0.5), 0.5);
  opacity->AddPoint(which.Scene.GetScalar(0.55), 0.0);
  return property;
}

// Isosurfaces alone, and a function that is mostly transparent, against the whole volume. Processor
// time does not depend on other work of the cores. Transparent cells are found in the second frame.
void AddSkipping(const TaskCase& which, const TaskEffort& effort, int size, TaskTable& table)
{
  const auto volume =
    MakeVolume(VolumeWay::Exact, which.Mesh, which.Scene.MakeProperty(which.Mesh, 11));
  const auto surface = MakeVolume(VolumeWay::Exact, which.Mesh, MakeSurfaces(which));
  GetMapper(surface)->SetBlendModeToIsoSurface();
  const auto peak = MakeVolume(VolumeWay::Exact, which.Mesh, MakePeak(which));
  BenchmarkView view(size, size);
  view.LookAt(which.Mesh->GetBounds());
  const std::vector<vtkProp*> props = { volume, surface, peak };
  std::vector<std::vector<double>> seconds(props.size());
  for (int round = -2; round < effort.Rounds; ++round)
  {
    view.MoveCamera(TaskTurn);
    for (size_t i = 0; i < props.size(); ++i)
    {
      ShowAlone(view, props[i]);
      const double begin = GetProcessorSeconds();
      view.TimeFrame();
      const double frame = GetProcessorSeconds() - begin;
      if (round >= 0)
      {
        seconds[i].push_back(frame);
      }
    }
  }
  const std::string pixels =
    ", " + std::to_string(size) + " x " + std::to_string(size) + ", processor time";
  table.Add("isosurface alone" + pixels, seconds[1], "the whole volume", seconds[0], 0.3);
  table.Add(
    "opacity in a tenth of the range" + pixels, seconds[2], "the whole volume", seconds[0], 1.0);
}

void AddSkippingOfSizes(const TaskCase& which, const TaskEffort& effort, TaskTable& table)
{
  for (const int size : { effort.Size, effort.LargeSize })
  {
    AddSkipping(which, effort, size, table);
  }
}

// A new isovalue and its picture.
void AddIsoValues(const TaskCase& which, const TaskEffort& effort, TaskTable& table)
{
  const auto property = MakeSurfaces(which);
  const auto surface = MakeVolume(VolumeWay::Exact, which.Mesh, property);
  GetMapper(surface)->SetBlendModeToIsoSurface();
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(which.Mesh);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  std::vector<double> ours;
  std::vector<double> theirs;
  const auto time = [&](vtkProp* prop, const std::function<void()>& change)
  {
    ShowAlone(view, prop);
    const Stopwatch stopwatch;
    change();
    view.TimeFrame();
    return stopwatch.GetSeconds();
  };
  for (int round = -1; round < effort.Rounds; ++round)
  {
    const double value = which.Scene.GetScalar(0.45 + 0.02 * round);
    view.MoveCamera(TaskTurn);
    const double first =
      time(surface, [&] { property->GetIsoSurfaceValues()->SetValue(0, value); });
    const double second = time(actor, [&] { contour->SetValue(0, value); });
    if (round >= 0)
    {
      ours.push_back(first);
      theirs.push_back(second);
    }
  }
  table.Add("isovalue change to picture", ours, "vtkContourFilter and its picture", theirs, 1.0);
}

// The same points and cells as other objects, moved or with other values.
vtkSmartPointer<vtkUnstructuredGrid> MakeStep(const TaskCase& which, double factor, double bend)
{
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->DeepCopy(which.Mesh);
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->SetComponent(i, 0, factor * values->GetComponent(i, 0));
    double point[3];
    mesh->GetPoint(i, point);
    point[2] += bend * point[0] * point[0];
    mesh->GetPoints()->SetPoint(i, point);
  }
  return mesh;
}

// Time steps against a mapper that has drawn no other step. The picture is small, so that loading
// takes most of the time.
void AddSteps(const TaskCase& which, const TaskEffort& effort, TaskTable& table)
{
  struct Kind
  {
    const char* Name;
    bool IsMoved;
    bool IsShaded;
    VolumeWay Way;
    double Asked;
  };
  const Kind kinds[] = { { "new values", false, false, VolumeWay::Exact, 0.15 },
    { "new values with shading", false, true, VolumeWay::Exact, 0.15 },
    { "new values with cell projection", false, false, VolumeWay::Projection, 0.15 },
    { "moved points", true, false, VolumeWay::Exact, 1.0 } };
  BenchmarkView view(32, 32);
  view.LookAt(which.Mesh->GetBounds());
  const auto time = [&](vtkVolume* volume, vtkUnstructuredGrid* step)
  {
    ShowAlone(view, volume);
    const Stopwatch stopwatch;
    GetMapper(volume)->SetInputData(step);
    view.TimeFrame();
    return stopwatch.GetSeconds();
  };
  for (const Kind& kind : kinds)
  {
    const auto property = which.Scene.MakeProperty(which.Mesh, 11);
    property->SetShade(kind.IsShaded);
    std::vector<double> ours;
    std::vector<double> built;
    const auto steps = MakeVolume(kind.Way, which.Mesh, property);
    time(steps, which.Mesh);
    for (int round = 0; round < effort.Rounds; ++round)
    {
      const double share = 0.1 * (round + 1);
      const auto step =
        kind.IsMoved ? MakeStep(which, 1.0, share) : MakeStep(which, 1.0 - share, 0.0);
      ours.push_back(time(steps, step));
      const auto other = MakeVolume(kind.Way, which.Mesh, property);
      built.push_back(time(other, step));
      view.GetRenderer()->RemoveViewProp(other);
    }
    view.GetRenderer()->RemoveViewProp(steps);
    table.Add(std::string(kind.Name) + " to picture", ours, "a new mesh", built, kind.Asked);
  }
}

// With a translucent sphere inside; processor time.
void AddPeeling(const TaskCase& which, const TaskEffort& effort, TaskTable& table)
{
  const auto volume =
    MakeVolume(VolumeWay::Exact, which.Mesh, which.Scene.MakeProperty(which.Mesh, 11));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(which.Mesh->GetCenter());
  sphere->SetRadius(0.3 * which.Mesh->GetLength());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  view.AddActor(mapper)->GetProperty()->SetOpacity(0.3);
  vtkRenderer* renderer = view.GetRenderer();
  renderer->AddViewProp(volume);
  std::vector<double> seconds[2];
  for (int round = -1; round < effort.Rounds; ++round)
  {
    view.MoveCamera(TaskTurn);
    for (int i = 0; i < 2; ++i)
    {
      renderer->SetUseDepthPeeling(i);
      renderer->SetUseDepthPeelingForVolumes(i != 0);
      const double begin = GetProcessorSeconds();
      view.TimeFrame();
      const double frame = GetProcessorSeconds() - begin;
      if (round >= 0)
      {
        seconds[i].push_back(frame);
      }
    }
  }
  table.Add("depth peeling, processor time", seconds[1], "without depth peeling", seconds[0], 3.0);
}

// A drag of two seconds: a mouse sends events at 60 Hz, which wait while a frame is drawn. The time
// from the release of the button to the still picture is compared with a still frame.
void AddDrag(const TaskCase& which, const TaskEffort& effort, TaskTable& table)
{
  const auto volume =
    MakeVolume(VolumeWay::Exact, which.Mesh, which.Scene.MakeProperty(which.Mesh, 11));
  BenchmarkView view(effort.Size, effort.Size);
  view.LookAt(which.Mesh->GetBounds());
  view.GetRenderer()->AddViewProp(volume);
  vtkRenderWindow* window = view.GetRenderer()->GetRenderWindow();
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  view.TimeFrame();
  std::vector<double> settled;
  std::vector<double> still;
  const double duration = effort.Size > 100 ? 2.0 : 0.1;
  for (int round = 0; round < effort.Rounds; ++round)
  {
    const int half = effort.Size / 2;
    interactor->SetEventInformation(half, half);
    interactor->LeftButtonPressEvent();
    const Stopwatch stopwatch;
    const int count = static_cast<int>(60.0 * duration);
    for (int i = 1; i <= count && stopwatch.GetSeconds() < MostOfDrag * duration; ++i)
    {
      const double wait = i / 60.0 - stopwatch.GetSeconds();
      std::this_thread::sleep_for(std::chrono::duration<double>(std::max(wait, 0.0)));
      interactor->SetEventInformation(half + half * i / (2 * count), half);
      interactor->MouseMoveEvent();
    }
    interactor->LeftButtonReleaseEvent();
    window->WaitForCompletion();
    settled.push_back(stopwatch.GetSeconds() - duration);
    still.push_back(view.TimeFrame());
  }
  interactor->SetRenderWindow(nullptr);
  table.Add("end of a drag to still picture", settled, "a still frame", still, 1.5);
}

void AddMemory(const TaskEffort& effort, BenchmarkTable& memory)
{
  for (const std::string& scene : effort.MemoryScenes)
  {
    for (const char* host : { "keep", "free" })
    {
      const std::vector<double> bytes = RunInOwnProcess({ "volumes", "memory", scene, host });
      if (bytes.size() == 5)
      {
        memory.AddRow({ bytes[0], std::string(host), 1e-6 * bytes[1], 1e-6 * bytes[2],
          bytes[2] / bytes[1], 1.5, 1e-6 * bytes[3], bytes[3] / bytes[1], 1e-6 * bytes[4] });
      }
    }
  }
}
}

std::vector<double> MeasureVolumeMemory(const std::vector<std::string>& arguments)
{
  BenchmarkView view(64, 64);
  {
    // The shaders and OpenGL's own memory.
    const TaskCase small("bent 4");
    view.LookAt(small.Mesh->GetBounds());
    view.GetRenderer()->AddViewProp(
      MakeVolume(VolumeWay::Exact, small.Mesh, small.Scene.MakeProperty(small.Mesh, 11)));
    view.TimeFrame();
    view.GetRenderer()->RemoveAllViewProps();
  }
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkSmartPointer<vtkVolumeProperty> property;
  {
    const BenchmarkVolumeScene scene(arguments.at(0));
    mesh = scene.MakeMesh(BenchmarkVolumeScene::UNSPLIT);
    mesh->Squeeze();
    property = scene.MakeProperty(mesh, 11);
  }
  view.LookAt(mesh->GetBounds());
  const double residentBefore = GetResidentMemory().Current;
  CountAllocatedMemory();
  const auto volume = MakeVolume(VolumeWay::Exact, mesh, property);
  GetMapper(volume)->SetKeepHostData(arguments.at(1) == "keep");
  view.GetRenderer()->AddViewProp(volume);
  view.TimeFrame();
  const AllocatedMemory after = GetAllocatedMemory();
  return { static_cast<double>(mesh->GetNumberOfCells()),
    1024.0 * static_cast<double>(mesh->GetActualMemorySize()), after.Peak, after.Current,
    GetResidentMemory().Peak - residentBefore };
}

namespace
{
using Task = std::pair<const char*, void (*)(const TaskCase&, const TaskEffort&, TaskTable&)>;

BenchmarkTable MeasureTasks(
  const std::string& name, const TaskEffort& effort, const std::vector<Task>& all)
{
  BenchmarkTable table(name, "What users do with volumes",
    { { "cells", "hexahedra", 0 }, { "measured", "measured", 0 }, { "ms", "ms", 1 },
      { "against", "against", 0 }, { "against_ms", "ms", 1 }, { "ratio", "ratio", 3 },
      { "asked", "asked", 2 } });
  const TaskCase which(effort.Scene);
  TaskTable tasks(which, table);
  for (const Task& task : all)
  {
    std::cerr << "volumes: " << task.first << std::endl;
    task.second(which, effort, tasks);
  }
  table.AddNote(std::to_string(effort.Size) + " x " + std::to_string(effort.Size) +
    " pixels, the camera turns, frames in turn; ratios are medians. Steps: 32 x 32 pixels.");
  return table;
}
}

void RunVolumeSkipping(const BenchmarkOptions& options, const AddTable& addTable)
{
  addTable(MeasureTasks("volumes-skipping", GetTaskEffort(options),
    { { "skipping", AddSkippingOfSizes }, { "isovalues", AddIsoValues } }));
}

void RunVolumeTasks(const BenchmarkOptions& options, const AddTable& addTable)
{
  const TaskEffort effort = GetTaskEffort(options);
  addTable(MeasureTasks("volumes-tasks", effort,
    { { "steps", AddSteps }, { "peeling", AddPeeling }, { "drag", AddDrag } }));
  BenchmarkTable memory("volumes-host-memory",
    "Memory that the process allocates for a volume, without the data set and OpenGL's buffers",
    { { "cells", "hexahedra", 0 }, { "host", "host data", 0 }, { "mesh_mb", "data set, MB", 1 },
      { "peak_mb", "peak, MB", 1 }, { "ratio", "ratio", 2 }, { "asked", "asked", 2 },
      { "after_mb", "after, MB", 1 }, { "ratio_after", "ratio", 2 },
      { "resident_mb", "resident peak, MB", 1 } });
  AddMemory(effort, memory);
  memory.AddNote("The peak counts what C++ code allocates while the mesh is built. A software "
                 "renderer stores OpenGL's buffers in the memory of the process, so the resident "
                 "peak includes them.");
  addTable(memory);
}
