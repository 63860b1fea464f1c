// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares Phong tessellation with PN triangles for the published numbers of triangles.
#include "BenchmarkFrames.h"
#include "BenchmarkMeshes.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr int Level = 4;

struct Row
{
  const char* Model;
  double Triangles; // millions
  double Phong, PN; // published frames per second
};
const Row Rows[] = { { "person", 0.103, 82, 54 }, { "person", 0.616, 65, 43 },
  { "person", 1.33, 51, 33 }, { "person", 2.46, 31, 20 }, { "person", 3.80, 22, 14 },
  { "person", 5.54, 16, 10 }, { "person", 7.49, 12, 8 }, { "person", 9.85, 9, 6 },
  { "person", 12.40, 8, 5 }, { "person", 15.40, 7, 4 }, { "person", 18.60, 6, 3 },
  { "tiger", 0.036, 135, 107 }, { "tiger", 0.47, 101, 74 }, { "tiger", 0.87, 72, 50 },
  { "tiger", 1.30, 53, 37 }, { "tiger", 2.00, 42, 28 }, { "tiger", 2.60, 32, 22 },
  { "tiger", 3.50, 26, 17 }, { "tiger", 4.40, 22, 14 }, { "tiger", 5.40, 18, 11 },
  { "tiger", 6.50, 15, 9 }, { "tiger", 7.80, 12, 8 }, { "tiger", 9.1, 11, 7 },
  { "tiger", 11.0, 9, 6 }, { "tiger", 12.0, 8, 5 }, { "tiger", 14.0, 7, 4 },
  { "tiger", 16.0, 6, 4 } };

enum
{
  PHONG,
  PN_QUADRATIC,
  PN_LINEAR
};

vtkSmartPointer<vtkAdaptiveRefinementMapper> MakeMapper(
  vtkPolyData* mesh, vtkRefinementSurface* surface)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(Level);
  recipe->SetSurface(surface);
  auto mapper = vtkSmartPointer<vtkAdaptiveRefinementMapper>::New();
  mapper->SetInputData(mesh);
  mapper->SetRefinement(recipe);
  mapper->FrustumCullingOff();
  return mapper;
}

void Measure(const Row& row, const BenchmarkOptions& options, BenchmarkTable& table)
{
  const auto mesh = BenchmarkMeshes::MakeSphere(1e6 * row.Triangles / (1 << 2 * Level));
  vtkNew<vtkPhongSurface> phong;
  vtkNew<vtkPNTriangleSurface> quadratic;
  vtkNew<vtkPNTriangleSurface> linear;
  linear->QuadraticNormalsOff();
  const auto mappers = { MakeMapper(mesh, phong), MakeMapper(mesh, quadratic),
    MakeMapper(mesh, linear) };
  const std::vector<vtkMapper*> drawn(mappers.begin(), mappers.end());
  std::vector<double> figures;
  // In view and out of view.
  for (const bool isAway : { false, true })
  {
    BenchmarkView view(160, 120);
    view.LookAt((*mappers.begin())->GetBounds());
    if (isAway)
    {
      view.LookAway();
    }
    BenchmarkFrames frames(view, drawn);
    if (options.Quick)
    {
      frames.Measure(2);
    }
    else
    {
      frames.Measure(options.Full ? 31 : 9, 3, options.Full ? 6.0 : 0.7);
    }
    for (const size_t m : { PHONG, PN_QUADRATIC, PN_LINEAR })
    {
      figures.push_back(frames.GetMedian(m));
    }
    for (const size_t m : { PN_QUADRATIC, PN_LINEAR })
    {
      figures.push_back(frames.GetRatio(m, PHONG));
      figures.push_back(frames.GetProcessorRatio(m, PHONG));
    }
  }
  std::vector<BenchmarkTable::Value> values = { std::string(row.Model),
    static_cast<double>(mesh->GetNumberOfPolys()), row.Triangles,
    1e-6 * static_cast<double>(mesh->GetNumberOfPolys() << 2 * Level), row.Phong / row.PN };
  values.insert(values.end(), figures.begin(), figures.end());
  table.AddRow(values);
}
}

void RunPhong(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("phong", "Phong tessellation against PN triangles, 160 x 120 pixels",
    { { "model", "published model", 0 }, { "faces", "in", 0 },
      { "published_millions", "out, published, M", 3 }, { "millions", "out, M", 3 },
      { "published_ratio", "PN / Phong, published", 2 }, { "phong_ms", "Phong, ms", 1 },
      { "pn_ms", "PN, ms", 1 }, { "pn_linear_ms", "PN, linear normals, ms", 1 },
      { "pn_per_phong", "PN / Phong", 2 }, { "pn_per_phong_processor", "of processor time", 2 },
      { "pn_linear_per_phong", "linear normals / Phong", 2 },
      { "pn_linear_per_phong_processor", "of processor time", 2 },
      { "phong_vertices_ms", "vertices: Phong, ms", 1 }, { "pn_vertices_ms", "PN, ms", 1 },
      { "pn_linear_vertices_ms", "PN, linear normals, ms", 1 },
      { "pn_per_phong_vertices", "vertices: PN / Phong", 2 },
      { "pn_per_phong_vertices_processor", "of processor time", 2 },
      { "pn_linear_per_phong_vertices", "linear normals / Phong", 2 },
      { "pn_linear_per_phong_vertices_processor", "of processor time", 2 } });
  for (const Row& row : Rows)
  {
    const double largest = options.Quick ? 0.05 : options.Full ? 20.0 : 2.5;
    if (row.Triangles <= largest)
    {
      std::cerr << "phong: " << row.Model << ", " << row.Triangles << " M" << std::endl;
      Measure(row, options, table);
    }
  }
  table.AddNote("Published: tables 3.1 and 3.2 of the study of both on the tessellation pipeline "
                "(models of a person and of a tiger, many copies, unlit). Here: a sphere with "
                "about as many triangles, every face at level " +
    std::to_string(Level) +
    ", no culling. Vertices: the same while the camera looks away, so that every vertex is "
    "computed and no pixel drawn. Medians, in turn.");
  addTable(table);
}
