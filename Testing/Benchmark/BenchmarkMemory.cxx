// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures resident memory of each way in a separate process. It includes the graphics memory of a
// software renderer.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <cstdlib>

// static|refined FACES TRIANGLES -> growth and peak in bytes
std::vector<double> MeasureMemory(const std::vector<std::string>& arguments)
{
  const bool isStatic = arguments.at(0) == "static";
  BenchmarkSurface surface(std::atoi(arguments.at(1).c_str()), std::atof(arguments.at(2).c_str()));
  BenchmarkView view;
  view.LookAt(surface.GetMesh()->GetBounds());
  const double before = GetResidentMemory().Current;
  if (isStatic)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface.MakeRefinedMesh());
    view.AddActor(mapper);
  }
  else
  {
    vtkNew<vtkAdaptiveRefinementMapper> mapper;
    mapper->SetInputData(surface.GetMesh());
    mapper->SetRefinement(BenchmarkSurface::MakeLinearRecipe());
    view.AddActor(mapper);
  }
  for (int frame = 0; frame < 2; ++frame)
  {
    view.MoveCamera();
    view.TimeFrame();
  }
  const ResidentMemory after = GetResidentMemory();
  return { after.Current - before, after.Peak - before };
}

void RunMemory(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("memory", "Resident memory: Relevo's mapper (B) against a static mesh (A)",
    { { "coarse_faces", "coarse", 0 }, { "drawn_triangles", "drawn", 0 },
      { "resident_a_mb", "A, MB", 0 }, { "resident_b_mb", "B, MB", 0 },
      { "resident_percent", "B / A, %", 1 }, { "peak_a_mb", "peak A, MB", 0 },
      { "peak_b_mb", "peak B, MB", 0 } });
  struct Size
  {
    double Faces;
    double Triangles;
  };
  const std::vector<Size> sizes = options.Quick
    ? std::vector<Size>{ { 200, 5e3 } }
    : std::vector<Size>{ { 2000, 8e6 }, { 20000, 8e6 }, { 200000, 8e6 } };
  for (const Size& size : sizes)
  {
    const std::string faces = std::to_string(size.Faces);
    const std::string triangles = std::to_string(size.Triangles);
    const auto a = RunInOwnProcess({ "memory", "static", faces, triangles });
    const auto b = RunInOwnProcess({ "memory", "refined", faces, triangles });
    if (a.size() == 2 && b.size() == 2)
    {
      table.AddRow({ size.Faces, size.Triangles, 1e-6 * a[0], 1e-6 * b[0], 100.0 * b[0] / a[0],
        1e-6 * a[1], 1e-6 * b[1] });
    }
  }
  table.AddNote("Growth after two frames over a process with an empty window and the coarse mesh, "
                "each way in a process "
                "of its own. A holds the mesh that its mapper draws, made by "
                "vtkAdaptiveRefinementFilter; its peak includes that filter.");
  addTable(table);
}
