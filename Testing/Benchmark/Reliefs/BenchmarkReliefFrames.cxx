// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReliefFrames.h"

#include "BenchmarkFrames.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkPixelMesh.h"
#include "BenchmarkReliefScene.h"
#include "BenchmarkReliefWay.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Data/Relief.h"
#include "vtkReliefMapper.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <cstdlib>

namespace
{
double GetValidTexels(vtkMultiBlockDataSet* reliefs)
{
  double valid = 0.0;
  for (const auto& image : GetReliefs(reliefs))
  {
    relevo::Relief relief;
    relief.Read(image);
    valid += static_cast<double>(relief.GetNumberOfValidTexels());
  }
  return valid;
}
}

void AddReliefFrames(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("relief", "Frames of four captures against those of what they show",
    { { "shown_triangles", "triangles", 0 }, { "texels", "valid texels", 0 },
      { "way", "drawn by", 0 }, { "relief_ms", "reliefs, ms", 1 }, { "mesh_ms", "mesh, ms", 1 },
      { "ratio", "reliefs / mesh", 3 }, { "ratio_less", "reliefs / those of a mesh of 1/8", 3 },
      { "first_ms", "first picture, ms", 0 }, { "memory_mb", "graphics memory, MB", 1 } });
  const double many = options.Quick ? 8e3 : 8e6;
  const int size = options.Quick ? 64 : 1024;
  BenchmarkView view(options.Quick ? 128 : 1024, options.Quick ? 96 : 768);
  const BenchmarkReliefScene scene(many);
  scene.SetUp(view);
  const auto reliefs = scene.Capture(view, size);
  const auto fewer = BenchmarkReliefScene(many / 8.0).Capture(view, size);
  vtkNew<vtkActor> object;
  object->SetMapper(scene.MakeMapper());
  std::vector<vtkSmartPointer<vtkActor>> actors;
  std::vector<double> firstPictures;
  for (const ReliefWay way : GetReliefWays())
  {
    actors.push_back(MakeReliefActor(way, reliefs));
    view.GetRenderer()->AddActor(actors.back());
    firstPictures.push_back(1e3 * view.TimeFrame());
    view.GetRenderer()->RemoveActor(actors.back());
    actors.push_back(MakeReliefActor(way, fewer));
  }
  std::vector<vtkProp*> props = { object };
  props.insert(props.end(), actors.begin(), actors.end());
  BenchmarkFrames frames(view, props);
  frames.SetTurn(1.0);
  frames.Measure(options.Quick ? 1 : 7);
  for (size_t i = 0; i < GetReliefWays().size(); ++i)
  {
    table.AddRow({ static_cast<double>(scene.GetMesh()->GetNumberOfPolys()),
      GetValidTexels(reliefs), GetName(GetReliefWays()[i]), frames.GetMedian(1 + 2 * i),
      frames.GetMedian(0), frames.GetRatio(1 + 2 * i, 0), frames.GetRatio(1 + 2 * i, 2 + 2 * i),
      firstPictures[i],
      1e-6 * vtkReliefMapper::SafeDownCast(actors[2 * i]->GetMapper())->GetGraphicsMemorySize() });
  }
  table.AddNote("Asked: 0.3 of the mesh, and 1.1 times the reliefs of a mesh of an eighth of the "
                "triangles.");
  addTable(table);
}

std::vector<double> MeasureReliefMemory(const std::vector<std::string>& arguments)
{
  const auto reliefs = MakeWavyReliefs(std::atoi(arguments.at(1).c_str()));
  BenchmarkView view;
  const double bounds[] = { -1.0, 1.0, -1.0, 1.0, -0.02, 0.02 };
  view.LookAt(bounds);
  const double before = GetResidentMemory().Current;
  const auto actor = arguments.at(0) == "pixels"
    ? MakePixelMeshActor(MakePixelMesh(GetReliefs(reliefs)))
    : MakeReliefActor(ReliefWay::MaximumMipmap, reliefs);
  BenchmarkFrames(view, std::vector<vtkProp*>{ actor }).Measure(2);
  return { GetResidentMemory().Current - before, GetValidTexels(reliefs) };
}

void AddReliefMemory(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("relief-memory", "Resident memory: reliefs against a mesh of their pixels",
    { { "texels", "valid texels", 0 }, { "relief_bytes", "reliefs, bytes a texel", 1 },
      { "mesh_bytes", "mesh of pixels, bytes a texel", 1 }, { "ratio", "ratio", 3 } });
  const std::string size = options.Quick ? "64" : "1024";
  const auto relief = RunInOwnProcess({ "relief", "memory", "reliefs", size });
  const auto mesh = RunInOwnProcess({ "relief", "memory", "pixels", size });
  if (relief.size() == 2 && mesh.size() == 2)
  {
    table.AddRow({ relief[1], relief[0] / relief[1], mesh[0] / mesh[1], relief[0] / mesh[0] });
  }
  table.AddNote(
    "Growth after four frames of four reliefs, over a process that has the reliefs, each "
    "way in a process of its own. Asked: 0.4.");
  addTable(table);
}
