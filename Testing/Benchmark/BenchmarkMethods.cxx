// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares the mapper's methods, with the meshes, numbers of triangles and gains of Lenz 2009,
// table 5.1 and chapter 5.
#include "BenchmarkFrames.h"
#include "BenchmarkLevels.h"
#include "BenchmarkMeshes.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkPolyData.h"
#include "vtkProceduralSurface.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
constexpr int BunnyFaces = 1500;

struct Method
{
  const char* Key;
  const char* Name;
  void (vtkAdaptiveRefinementMapper::*Choose)();
};
enum
{
  ARKFPI,
  ARK,
  DMR,
  SUAPT,
  TESSELLATION,
  UNIFORM
};
const Method Methods[] = {
  { "arkfpi", "ARKFPI", &vtkAdaptiveRefinementMapper::SetMethodToARKFPI },
  { "ark", "ARK", &vtkAdaptiveRefinementMapper::SetMethodToARK },
  { "dmr", "DMR", &vtkAdaptiveRefinementMapper::SetMethodToDMR },
  { "suapt", "SUAPT", &vtkAdaptiveRefinementMapper::SetMethodToSUAPT },
  { "tessellation", "tessellation", &vtkAdaptiveRefinementMapper::SetMethodToHardwareTessellation },
  { "uniform", "uniform", &vtkAdaptiveRefinementMapper::SetMethodToUniform },
};

struct Row
{
  const char* Mesh;
  double Triangles; // approximate number to draw
  double Gain;      // published gain of ARKFPI over ARK, %
};
// The published meshes and rows. "bunny" and "fur" share a mesh.
const Row Rows[] = { { "sphere1", 25312, 79.2 }, { "sphere1", 11006, 140.5 },
  { "sphere1", 8848, 191.8 }, { "sphere2", 4758, 283.8 }, { "sphere2", 8856, 222.0 },
  { "sphere2", 16476, 289.9 }, { "pacman1", 73094, 156.5 }, { "pacman1", 25154, 261.5 },
  { "pacman1", 14154, 666.1 }, { "jet", 1174, 3065.2 }, { "jet", 4363, 2065.2 },
  { "jet", 10157, 1369.6 }, { "jet", 25226, 765.2 }, { "pacman2", 1974, 3478.6 },
  { "pacman2", 3846, 3021.4 }, { "pacman2", 8084, 2507.1 }, { "pacman2", 15170, 1607.1 },
  { "pacman2", 98146, 471.4 }, { "pacman2", 521536, 66.7 }, { "bunny", 380000, 555.6 },
  { "fur", 380000, 1144.4 } };

// The mesh of this name. Without the bunny's file, it is a sphere with another name.
vtkSmartPointer<vtkPolyData> MakeMesh(std::string& name)
{
  if (name == "sphere1")
  {
    return BenchmarkMeshes::MakeSphere(4, 2);
  }
  if (name == "sphere2")
  {
    return BenchmarkMeshes::MakeSphere(6, 4);
  }
  if (name == "pacman1")
  {
    return BenchmarkMeshes::MakePacMan(9, 5, 5);
  }
  if (name == "pacman2")
  {
    return BenchmarkMeshes::MakePacMan(16, 14, 7);
  }
  if (name == "jet")
  {
    return BenchmarkMeshes::MakeJet();
  }
  const auto bunny = BenchmarkMeshes::ReadBunny();
  if (!bunny)
  {
    name += " (on a sphere)";
    return BenchmarkMeshes::MakeSphere(BunnyFaces);
  }
  return BenchmarkMeshes::Decimate(bunny, BunnyFaces);
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(const Row& row, vtkPolyData* mesh)
{
  auto recipe = BenchmarkSurface::MakePNRecipe();
  if (std::string(row.Mesh) == "fur")
  {
    vtkNew<vtkProceduralSurface> fur;
    fur->SetAmplitude(0.02 * mesh->GetLength());
    fur->SetFrequency(3.0);
    recipe->SetSurface(fur);
  }
  return recipe;
}

struct Size
{
  int Width, Height;
};

void Measure(const Row& row, const Size& size, const BenchmarkOptions& options,
  BenchmarkTable& table, BenchmarkTable& work)
{
  std::string name = row.Mesh;
  const auto mesh = MakeMesh(name);
  const double triangles = BenchmarkLevels::SetRandomTags(mesh, row.Triangles);
  const auto recipe = MakeRecipe(row, mesh);
  std::vector<vtkSmartPointer<vtkAdaptiveRefinementMapper>> mappers;
  std::vector<vtkMapper*> drawn;
  for (const Method& method : Methods)
  {
    mappers.push_back(vtkSmartPointer<vtkAdaptiveRefinementMapper>::New());
    vtkAdaptiveRefinementMapper* mapper = mappers.back();
    mapper->SetInputData(mesh);
    mapper->SetRefinement(recipe);
    (mapper->*method.Choose)();
    // All faces are drawn, and moving the camera does not select levels again.
    mapper->FrustumCullingOff();
    drawn.push_back(mapper);
  }
  BenchmarkView view(size.Width, size.Height);
  view.LookAt(mappers[ARKFPI]->GetBounds());
  BenchmarkFrames frames(view, drawn);
  vtkIdType selections = 0;
  for (const auto& mapper : mappers)
  {
    selections -= mapper->GetNumberOfSelections();
  }
  if (options.Quick)
  {
    frames.Measure(2);
  }
  else
  {
    frames.Measure(options.Full ? 41 : 15, 5, options.Full ? 6.0 : 1.0);
  }
  for (const auto& mapper : mappers)
  {
    selections += mapper->GetNumberOfSelections();
  }

  const auto isDrawn = [&mappers](size_t m)
  { return mappers[m]->GetMethodInUse() == mappers[m]->GetMethod(); };
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double faces = static_cast<double>(mappers[ARKFPI]->GetNumberOfCoarseFaces());
  std::vector<BenchmarkTable::Value> values = { name, faces, row.Triangles, triangles,
    triangles / faces };
  for (size_t m = 0; m < mappers.size(); ++m)
  {
    values.push_back(isDrawn(m) ? frames.GetMedian(m) : none);
  }
  values.push_back(row.Gain);
  values.push_back(100.0 * (frames.GetRatio(ARK, ARKFPI) - 1.0));
  values.push_back(100.0 * (frames.GetProcessorRatio(ARK, ARKFPI) - 1.0));
  double wall = 0.0;
  double processor = 0.0;
  for (const size_t m : { DMR, SUAPT, TESSELLATION })
  {
    wall += isDrawn(m) ? std::log(frames.GetRatio(m, ARKFPI)) : none;
    processor += isDrawn(m) ? std::log(frames.GetProcessorRatio(m, ARKFPI)) : none;
  }
  values.push_back(std::exp(wall / 3.0));
  values.push_back(std::exp(processor / 3.0));
  values.push_back(static_cast<double>(selections));
  table.AddRow(values);

  values = { name, faces };
  for (const size_t m : { ARKFPI, ARK })
  {
    values.push_back(static_cast<double>(mappers[m]->GetNumberOfDrawCalls()));
  }
  for (const size_t m : { ARKFPI, DMR, SUAPT, TESSELLATION, UNIFORM })
  {
    values.push_back(
      isDrawn(m) ? static_cast<double>(mappers[m]->GetNumberOfDrawnTriangles()) : none);
  }
  for (size_t m = 0; m < mappers.size(); ++m)
  {
    values.push_back(
      isDrawn(m) ? 1e-6 * static_cast<double>(mappers[m]->GetGraphicsMemorySize()) : none);
  }
  work.AddRow(values);
}

std::vector<BenchmarkTable::Column> MakeColumns()
{
  std::vector<BenchmarkTable::Column> columns = { { "mesh", "mesh", 0 }, { "faces", "in", 0 },
    { "published_triangles", "out, published", 0 }, { "triangles", "out", 0 },
    { "triangles_per_face", "out / in", 0 } };
  for (const Method& method : Methods)
  {
    columns.push_back({ std::string(method.Key) + "_ms", std::string(method.Name) + ", ms", 2 });
  }
  columns.push_back({ "published_gain_percent", "gain over ARK, published, %", 0 });
  columns.push_back({ "gain_percent", "gain over ARK, %", 0 });
  columns.push_back({ "gain_processor_percent", "of processor time, %", 0 });
  columns.push_back({ "gain_others", "geometric mean of DMR, SUAPT, tessellation / ARKFPI", 2 });
  columns.push_back({ "gain_others_processor", "of processor time", 2 });
  columns.push_back({ "selections", "selections while measured", 0 });
  return columns;
}

std::vector<BenchmarkTable::Column> MakeWorkColumns()
{
  std::vector<BenchmarkTable::Column> columns = { { "mesh", "mesh", 0 }, { "faces", "in", 0 },
    { "arkfpi_draw_calls", "draw calls: ARKFPI", 0 }, { "ark_draw_calls", "ARK", 0 },
    { "arkfpi_triangles", "triangles: ARKFPI, ARK", 0 }, { "dmr_triangles", "DMR", 0 },
    { "suapt_triangles", "SUAPT", 0 }, { "tessellation_triangles", "tessellation", 0 },
    { "uniform_triangles", "uniform", 0 } };
  for (const Method& method : Methods)
  {
    columns.push_back({ std::string(method.Key) + "_mb",
      (&method == Methods ? "memory, MB: " : "") + std::string(method.Name), 2 });
  }
  return columns;
}
}

void RunMethods(const BenchmarkOptions& options, const AddTable& addTable)
{
  // In a small picture, vertices and draw calls have more weight than pixels.
  for (const Size& size : { Size{ 1024, 768 }, Size{ 160, 120 } })
  {
    const std::string pixels = std::to_string(size.Width) + " x " + std::to_string(size.Height);
    BenchmarkTable table(size.Width == 1024 ? "methods" : "methods-small",
      "Methods of drawing, " + pixels + " pixels", MakeColumns());
    BenchmarkTable work("methods-work", "Methods of drawing: what they draw", MakeWorkColumns());
    for (const Row& row : Rows)
    {
      // All meshes, each with the row of the fewest triangles.
      const bool isQuick = row.Triangles < 5000 && &row != &Rows[9];
      if (!options.Quick || isQuick)
      {
        std::cerr << "methods: " << row.Mesh << " -> " << row.Triangles << std::endl;
        Measure(row, size, options, table, work);
      }
    }
    table.AddNote("Published: Lenz 2009, table 5.1 and, for bunny and fur, the text of chapter 5. "
                  "PN triangles, but fur. Levels are random and the same for all methods. Every "
                  "face is drawn, the camera moves; medians, the methods in turn, in changing "
                  "order. Gain: frames per second against ARK's. Processor time: of all cores, "
                  "which other programs disturb less; it says nothing of a graphics card.");
    addTable(table);
    if (size.Width == 1024)
    {
      work.AddNote("SUAPT's triangles include degenerate ones, the uniform method's levels are the "
                   "highest of all. Memory: as GetGraphicsMemorySize() says, the coarse mesh "
                   "included.");
      addTable(work);
    }
  }
}
