// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares micro-meshes with their dense meshes and with VTK's decimation.
#include "BenchmarkDenseMeshes.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "Benchmarks.h"

#include "vtkMicroMeshFilter.h"
#include "vtkMicroMeshWriter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <unistd.h> // for getpid

namespace
{
// Above this number of triangles, distances and VTK's decimation are not measured.
constexpr double MostForDecimation = 300000.0;

enum Figure
{
  Triangles,
  Seconds,
  ProcessorSeconds,
  MemoryRatio,
  Faces,
  FileRatio,
  PackedRatio,
  Bound,
  Distance,
  DecimatedRatio,
  NumberOfFigures
};

double GetPackedSize(vtkPolyData* micro)
{
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
    ("relevo-benchmark-" + std::to_string(getpid()) + ".rmm");
  vtkNew<vtkMicroMeshWriter> writer;
  writer->SetInputData(micro);
  writer->SetFileName(file.string().c_str());
  writer->Write();
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  std::filesystem::remove(file);
  return size;
}
}

std::vector<double> MeasureMicroMeshes(const std::vector<std::string>& arguments)
{
  const auto dense = BenchmarkDenseMeshes::Make(arguments.at(0));
  const double tolerance = 0.01 * std::atof(arguments.at(1).c_str()) * dense->GetLength();
  std::vector<double> figures(NumberOfFigures, std::numeric_limits<double>::quiet_NaN());
  const auto triangles = static_cast<double>(dense->GetNumberOfPolys());
  vtkNew<vtkMicroMeshFilter> filter;
  filter->SetInputData(dense);
  filter->SetTolerance(tolerance);
  const double before = GetResidentMemory().Current;
  const double processor = GetProcessorSeconds();
  const Stopwatch watch;
  filter->Update();
  figures[Seconds] = watch.GetSeconds();
  figures[ProcessorSeconds] = GetProcessorSeconds() - processor;
  figures[MemoryRatio] = (GetResidentMemory().Peak - before) /
    (1024.0 * static_cast<double>(dense->GetActualMemorySize()));
  vtkPolyData* micro = filter->GetOutput();
  const double fileSize = BenchmarkDenseMeshes::GetFileSize(dense);
  figures[Triangles] = triangles;
  figures[Faces] = static_cast<double>(micro->GetNumberOfPolys());
  figures[FileRatio] = BenchmarkDenseMeshes::GetFileSize(micro) / fileSize;
  figures[PackedRatio] = GetPackedSize(micro) / fileSize;
  figures[Bound] = filter->GetError() / tolerance;
  if (triangles <= MostForDecimation)
  {
    const auto decoded = BenchmarkDenseMeshes::Decode(micro, filter->GetMaximumLevel());
    const double distance = BenchmarkDenseMeshes::GetDistance(decoded, dense);
    figures[Distance] = distance / tolerance;
    figures[DecimatedRatio] = figures[PackedRatio] * fileSize /
      BenchmarkDenseMeshes::GetFileSize(BenchmarkDenseMeshes::Decimate(dense, distance));
  }
  return figures;
}

void RunMicroMeshes(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("micromesh", "Micro-meshes of dense meshes",
    { { "mesh", "mesh", 0 }, { "triangles", "triangles", 0 },
      { "tolerance_percent", "tolerance, %", 2 }, { "seconds", "encoding, s", 2 },
      { "seconds_per_million", "s per million", 1 },
      { "processor_per_million", "processor, s per million", 1 },
      { "memory_ratio", "memory / input", 1 }, { "faces_percent", "faces, %", 2 },
      { "file_ratio", ".vtp / input", 3 }, { "packed_ratio", ".rmm / input", 3 },
      { "bound", "bound / tolerance", 3 }, { "distance", "distance / tolerance", 3 },
      { "ratio_decimated", ".rmm / vtkQuadricDecimation", 3 } });
  std::vector<std::string> meshes = { "20000" };
  std::vector<std::string> tolerances = { "0.1" };
  if (!options.Quick)
  {
    meshes = { "fandisk", "bunny", "turbineblade", "1000000" };
    tolerances = { "0.5", "0.1", "0.02" };
    if (options.Full)
    {
      meshes.insert(meshes.end(), { "4000000", "10000000" });
    }
  }
  for (const std::string& mesh : meshes)
  {
    if (std::atof(mesh.c_str()) == 0.0 && !BenchmarkDenseMeshes::Make(mesh))
    {
      table.AddNote(mesh + ": not found. RELEVO_TEST_DATA names a folder with mesh/" + mesh + ".");
      continue;
    }
    for (const std::string& tolerance : tolerances)
    {
      const auto figures = RunInOwnProcess({ "micromesh", mesh, tolerance });
      if (figures.size() != NumberOfFigures)
      {
        continue;
      }
      const double millions = 1e-6 * figures[Triangles];
      table.AddRow({ std::atof(mesh.c_str()) > 0.0 ? "sphere with relief" : mesh,
        figures[Triangles], std::atof(tolerance.c_str()), figures[Seconds],
        figures[Seconds] / millions, figures[ProcessorSeconds] / millions, figures[MemoryRatio],
        100.0 * figures[Faces] / figures[Triangles], figures[FileRatio], figures[PackedRatio],
        figures[Bound], figures[Distance], figures[DecimatedRatio] });
    }
  }
  table.AddNote(
    "Each row in its own process. Tolerances are in percent of the diagonal. Files are "
    "compared with the dense mesh as a compressed .vtp file, and with that of "
    "vtkQuadricDecimation at the same distance, which is measured at corners and centres "
    "of triangles in both directions by VTK's locator.");
  addTable(table);
}
