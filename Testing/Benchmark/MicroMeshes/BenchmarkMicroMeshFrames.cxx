// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares frames of micro-meshes with their dense meshes and VTK's actors with levels of detail.
#include "BenchmarkDenseMeshes.h"
#include "BenchmarkFrames.h"
#include "BenchmarkReport.h"
#include "BenchmarkStaticMapper.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkLODActor.h"
#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkMicroMeshFilter.h"
#include "vtkMicroMeshSurface.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkQuadricLODActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace
{
constexpr double Tolerance = 0.001;      // of the diagonal
constexpr double ScreenSpaceError = 1.0; // pixels
constexpr double FrameRate = 15.0;       // that vtkLODActor and vtkQuadricLODActor aim at

// The share of pixels that differ by more than 8 of 255 from those of another picture, of those
// that are not background in one of them.
double GetDifferentPixels(
  const std::vector<unsigned char>& one, const std::vector<unsigned char>& other)
{
  double number = 0.0;
  double different = 0.0;
  for (size_t i = 0; i + 2 < one.size(); i += 3)
  {
    int largest = 0;
    int sum = 0;
    for (size_t c = i; c < i + 3; ++c)
    {
      largest = std::max(largest, std::abs(int(one[c]) - int(other[c])));
      sum += one[c] + other[c];
    }
    number += sum > 0 ? 1.0 : 0.0;
    different += largest > 8 ? 1.0 : 0.0;
  }
  return 100.0 * different / std::max(1.0, number);
}

class Scene
{
public:
  explicit Scene(const std::string& name)
    : Mesh(BenchmarkDenseMeshes::Make(name))
  {
    this->Normals->SetInputData(this->Mesh);
    this->Normals->SplittingOff();
    this->Normals->ConsistencyOff();
    this->Static->SetInputConnection(this->Normals->GetOutputPort());
    this->Plain->SetInputConnection(this->Normals->GetOutputPort());
    this->Dense->SetMapper(this->Static);
    vtkNew<vtkMicroMeshFilter> filter;
    filter->SetInputData(this->Mesh);
    filter->SetTolerance(Tolerance * this->Mesh->GetLength());
    filter->Update();
    vtkNew<vtkMicroMeshErrorDepthTagMetric> metric;
    metric->SetScreenSpaceError(ScreenSpaceError);
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetSurface(vtkNew<vtkMicroMeshSurface>());
    recipe->SetMaximumLevel(filter->GetMaximumLevel());
    recipe->SetMetric(metric);
    this->Adaptive->SetInputData(filter->GetOutput());
    this->Adaptive->SetRefinement(recipe);
    this->Micro->SetMapper(this->Adaptive);
    this->Lod->SetMapper(this->Plain);
    this->Quadric->SetMapper(this->Plain);
  }

  std::vector<vtkProp*> GetProps()
  {
    return { this->Dense, this->Micro, this->Lod, this->Quadric };
  }

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<BenchmarkStaticMapper> Static;
  vtkNew<vtkAdaptiveRefinementMapper> Adaptive;

private:
  vtkNew<vtkPolyDataNormals> Normals;
  vtkNew<vtkPolyDataMapper> Plain;
  vtkNew<vtkActor> Dense;
  vtkNew<vtkActor> Micro;
  vtkNew<vtkLODActor> Lod;
  vtkNew<vtkQuadricLODActor> Quadric;
};

void AddRows(BenchmarkTable& table, const std::string& name, const std::string& view, Scene& scene,
  double zoom, int rounds)
{
  BenchmarkView window;
  window.LookAt(scene.Mesh->GetBounds());
  vtkRenderer* renderer = window.GetRenderer();
  renderer->GetActiveCamera()->Zoom(zoom);
  // vtkQuadricLODActor needs an interactor.
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(renderer->GetRenderWindow());
  renderer->GetRenderWindow()->SetDesiredUpdateRate(FrameRate);
  const std::vector<vtkProp*> props = scene.GetProps();
  const char* names[] = { "dense mesh", "micro-mesh", "vtkLODActor", "vtkQuadricLODActor" };
  std::vector<std::vector<unsigned char>> pictures;
  double micro = 0.0;
  for (vtkProp* prop : props)
  {
    prop->VisibilityOn();
    renderer->AddActor(prop);
    window.TimeFrame();
    window.TimeFrame();
    pictures.push_back(window.GetPicture());
    micro = std::max(micro, static_cast<double>(scene.Adaptive->GetGraphicsMemorySize()));
    renderer->RemoveActor(prop);
  }
  const double memory = scene.Static->GetGraphicsMemorySize();
  BenchmarkFrames frames(window, props);
  frames.Measure(rounds);
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (size_t i = 0; i < props.size(); ++i)
  {
    table.AddRow({ name, view, std::string(names[i]), frames.GetMedian(i), frames.GetRatio(i, 0),
      i > 1 ? nothing : 1e-6 * (i == 0 ? memory : micro),
      i > 1 ? nothing : (i == 0 ? 1.0 : micro / memory),
      GetDifferentPixels(pictures[i], pictures[0]) });
  }
}
}

void RunMicroMeshFrames(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("micromesh-frames", "Frames of dense meshes as micro-meshes",
    { { "mesh", "mesh", 0 }, { "view", "view", 0 }, { "way", "way", 0 },
      { "frame_ms", "frame, ms", 1 }, { "ratio_frame", "of the dense mesh", 3 },
      { "ratio_memory_mb", "graphics memory, MB", 2 }, { "ratio_memory", "of the dense mesh", 3 },
      { "different_percent", "different pixels, %", 2 } });
  std::vector<std::string> meshes = { "20000" };
  if (!options.Quick)
  {
    meshes = { "1000000" };
    if (BenchmarkDenseMeshes::Make("turbineblade"))
    {
      meshes.insert(meshes.begin(), "turbineblade");
    }
  }
  for (const std::string& mesh : meshes)
  {
    Scene scene(mesh);
    const std::string name = std::atof(mesh.c_str()) > 0.0 ? "sphere with relief" : mesh;
    const int rounds = options.Quick ? 2 : 15;
    AddRows(table, name, "far, about 300 pixels", scene, 0.45, rounds);
    AddRows(table, name, "near", scene, 4.0, rounds);
  }
  table.AddNote(
    "1024 x 768, tolerance of 0.1 % of the diagonal, one pixel. The camera "
    "moves with every frame. vtkLODActor and vtkQuadricLODActor aim at 15 frames per "
    "second. Pixels are different if they differ by more than 8 of 255 from those of the "
    "dense mesh.");
  addTable(table);
}
