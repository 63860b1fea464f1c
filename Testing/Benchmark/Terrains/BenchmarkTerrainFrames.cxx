// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainFrames.h"

#include "BenchmarkFrames.h"
#include "BenchmarkRaster.h"
#include "BenchmarkReport.h"
#include "BenchmarkTerrainError.h"
#include "BenchmarkTerrainFiles.h"
#include "BenchmarkView.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkRenderer.h"

#include <cmath>
#include <limits>

namespace
{
// Two triangles for each square of samples, with point normals.
vtkSmartPointer<vtkPolyData> MakeFullMesh(
  const BenchmarkRaster& raster, const relevo::TerrainPlacement& placement)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const vtkIdType width = raster.GetWidth();
  for (int row = 0; row < raster.GetHeight(); ++row)
  {
    for (int column = 0; column < raster.GetWidth(); ++column)
    {
      const vtkIdType id = points->InsertNextPoint(
        placement.ToWorld(column, row, raster.GetSample(column, row)).data());
      if (row > 0 && column > 0)
      {
        const vtkIdType triangles[2][3] = { { id - width - 1, id - 1, id },
          { id - width - 1, id, id - width } };
        cells->InsertNextCell(3, triangles[0]);
        cells->InsertNextCell(3, triangles[1]);
      }
    }
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

struct TerrainViewpoint
{
  const char* Name;
  bool IsNear;
  bool IsAbove;
};

void Look(BenchmarkView& view, const double bounds[6], const TerrainViewpoint& viewpoint)
{
  vtkCamera* camera = view.GetRenderer()->GetActiveCamera();
  const double center[2] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) };
  const double size = bounds[3] - bounds[2];
  if (viewpoint.IsNear)
  {
    camera->SetPosition(center[0], bounds[2] + 0.15 * size, bounds[5] + 0.01 * size);
    camera->SetFocalPoint(center[0], center[1], bounds[4]);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
  else if (viewpoint.IsAbove)
  {
    camera->SetPosition(center[0], center[1], bounds[5] + 1.8 * size);
    camera->SetFocalPoint(center[0], center[1], bounds[4]);
    camera->SetViewUp(0.0, 1.0, 0.0);
  }
  else
  {
    view.LookAt(bounds);
  }
}

// The widest grid within a pixel; NaN triangles if a grid of quarters of samples is not.
BenchmarkTerrainError::Grid FindGrid(const BenchmarkTerrainError& error, double& spacing)
{
  for (const double s :
    { 24.0, 16.0, 12.0, 10.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5, 1.0, 0.5, 0.25 })
  {
    const BenchmarkTerrainError::Grid grid = error.MeasureGrid(s, 1.0);
    if (grid.Error <= 1.0)
    {
      spacing = s;
      return grid;
    }
  }
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  spacing = unknown;
  return { unknown, unknown };
}
}

void AddTerrainFrames(const BenchmarkOptions& options, const AddTable& addTable)
{
  const int viewport[2] = { options.Quick ? 160 : 1280, options.Quick ? 100 : 800 };
  const BenchmarkRaster raster = BenchmarkRaster::MakeMountain(options.Quick ? 129 : 1201);
  const std::string fileName =
    GetTerrainFile(options, "mountain-" + std::to_string(raster.GetWidth()) + ".tif");
  BenchmarkTable frameTable("terrain-frames",
    "A mountain within one pixel: vtkTerrainMapper (A) against its full mesh in "
    "vtkPolyDataMapper (B)",
    { { "view", "view", 0 }, { "triangles_a", "triangles of A", 0 },
      { "triangles_b", "triangles of B", 0 }, { "a_ms", "A, ms", 1 }, { "b_ms", "B, ms", 1 },
      { "ratio", "A / B", 3 }, { "error", "largest error of A, pixels", 3 },
      { "error_b", "of B", 3 } });
  BenchmarkTable gridTable("terrain-grid",
    "Triangles in view: vtkTerrainMapper against a uniform grid within one pixel",
    { { "view", "view", 0 }, { "triangles", "triangles", 0 }, { "error", "error, pixels", 3 },
      { "ratio_spacing", "samples between the points of the grid", 2 },
      { "ratio_grid_triangles", "triangles of the grid", 0 },
      { "ratio_grid_error", "its error, pixels", 3 }, { "ratio_triangles", "ratio", 3 } });
  const vtkSmartPointer<vtkTerrainPyramid> pyramid =
    WriteTerrainPyramid(raster, fileName) ? OpenTerrain(fileName) : nullptr;
  if (!pyramid)
  {
    frameTable.AddNote("No file can be written to " + fileName + ".");
    addTable(frameTable);
    return;
  }
  BenchmarkTerrainError error(raster, pyramid);
  const vtkSmartPointer<vtkPolyData> mesh = MakeFullMesh(raster, error.GetPlacement());
  for (const TerrainViewpoint& viewpoint : { TerrainViewpoint{ "oblique, all", false, false },
         TerrainViewpoint{ "from above, all", false, true },
         TerrainViewpoint{ "oblique, near", true, false } })
  {
    BenchmarkView view(viewport[0], viewport[1]);
    vtkNew<vtkTerrainMapper> terrain;
    terrain->SetPyramid(pyramid);
    terrain->SetLoadingModeToComplete();
    vtkNew<vtkPolyDataMapper> full;
    full->SetInputData(mesh);
    vtkCamera* camera = view.GetRenderer()->GetActiveCamera();
    Look(view, terrain->GetBounds(), viewpoint);
    vtkNew<vtkTerrainMeshSource> source;
    source->SetPyramid(pyramid);
    source->SetCamera(camera);
    source->SetViewportSize(viewport[0], viewport[1]);
    source->Update();
    error.SetCamera(camera, viewport);
    const double measured = error.Measure(source->GetOutput());
    double spacing = 0.0;
    const BenchmarkTerrainError::Grid grid = FindGrid(error, spacing);
    const auto triangles = static_cast<double>(source->GetOutput()->GetNumberOfCells());
    gridTable.AddRow({ std::string(viewpoint.Name), triangles, measured, spacing, grid.Triangles,
      grid.Error, triangles / grid.Triangles });
    BenchmarkFrames frames(view, std::vector<vtkMapper*>{ terrain, full });
    frames.Measure(options.Quick ? 2 : 21);
    frameTable.AddRow(
      { std::string(viewpoint.Name), static_cast<double>(terrain->GetNumberOfDrawnTriangles()),
        static_cast<double>(mesh->GetNumberOfCells()), frames.GetMedian(0), frames.GetMedian(1),
        frames.GetRatio(0, 1), measured, error.MeasureGrid(1.0, 1e9).Error });
  }
  const std::string what = (raster.IsReal() ? "Mount Rainier" : "A fractal") + std::string(", ") +
    std::to_string(raster.GetWidth()) + " x " + std::to_string(raster.GetHeight()) + " samples, " +
    std::to_string(viewport[0]) + " x " + std::to_string(viewport[1]) + " pixels. ";
  frameTable.AddNote(what + "The camera turns by half a degree per frame. Asked: 0.5.");
  gridTable.AddNote(what +
    "The grid is the widest of 16 spacings from 24 to 0.25 samples; only its "
    "triangles in view count. Asked: 0.5.");
  addTable(frameTable);
  addTable(gridTable);
}
