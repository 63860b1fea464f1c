// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPatchTriangles.h"

#include "BenchmarkPatchMeshes.h"
#include "BenchmarkReport.h"
#include "RelevoPatchDistance.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace
{
constexpr double Pixels = 0.5;
constexpr int LastLevel = 8;                   // vtkDataSetSurfaceFilter then gives 9.4 M triangles
constexpr vtkIdType MeasuredTriangles = 60000; // about this many are measured in larger meshes

int GetHeight(int width)
{
  return 3 * width / 4;
}

vtkSmartPointer<vtkCamera> MakeCamera(vtkDataSet* data, double zoom)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  RelevoLookAt(data, camera);
  const double distance = camera->GetDistance();
  camera->SetClippingRange(0.01 * distance, 2.0 * distance);
  camera->Zoom(zoom);
  return camera;
}

// For each point, a bit for each frustum plane that it lies outside of.
std::vector<unsigned char> FindOutside(vtkPolyData* mesh, vtkCamera* camera)
{
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0);
  std::vector<unsigned char> outside(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    mesh->GetPoint(i, x);
    matrix->MultiplyPoint(x, x);
    outside[i] = static_cast<unsigned char>(
      (x[0] < -x[3]) | (x[0] > x[3]) << 1 | (x[1] < -x[3]) << 2 | (x[1] > x[3]) << 3);
  }
  return outside;
}

struct View
{
  View(vtkPolyData* mesh, vtkCamera* camera)
  {
    const auto outside = FindOutside(mesh, camera);
    vtkDataArray* patches = mesh->GetCellData()->GetArray("vtkOriginalCellIds");
    struct Patch
    {
      unsigned char Outside = 0xff;
      int Triangles = 0;
    };
    std::map<int, Patch> all;
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
    {
      mesh->GetPolys()->GetCellAtId(cell, ids);
      const auto common = static_cast<unsigned char>(
        outside[ids->GetId(0)] & outside[ids->GetId(1)] & outside[ids->GetId(2)]);
      if (common == 0)
      {
        triangles->InsertNextCell(ids);
      }
      Patch& patch = all[patches ? static_cast<int>(patches->GetComponent(cell, 0)) : 0];
      patch.Outside &= common;
      ++patch.Triangles;
    }
    for (const auto& patch : all)
    {
      this->Unculled += patch.second.Outside == 0 ? patch.second.Triangles : 0.0;
    }
    this->Shown->SetPoints(mesh->GetPoints());
    this->Shown->SetPolys(triangles);
  }

  vtkNew<vtkPolyData> Shown; // without triangles outside of a plane
  double Unculled = 0.0;     // triangles without those of patches outside, which are culled
};

struct Triangles
{
  double All = 0.0;
  double Unculled = 0.0;
  double InView = 0.0;
  double Error = 0.0; // pixels, for visible triangles
};

class Contest
{
public:
  Contest(double zoom, bool quick)
    : Grid(BenchmarkPatchMeshes::MakeTeapot())
    , Coarse(BenchmarkPatchMeshes::MakePatches(Grid, true))
    , Parted(BenchmarkPatchMeshes::Part(Grid))
    , Camera(MakeCamera(Coarse, zoom))
    , Distance(Coarse, quick ? 48 : 192)
  {
  }

  Triangles Measure(vtkPolyData* mesh, int width) const
  {
    const View view(mesh, this->Camera);
    const int stride = static_cast<int>(view.Shown->GetNumberOfPolys() / MeasuredTriangles) | 1;
    return { static_cast<double>(mesh->GetNumberOfPolys()), view.Unculled,
      static_cast<double>(view.Shown->GetNumberOfPolys()),
      this->Distance.MeasurePixels(view.Shown, this->Camera, GetHeight(width), stride) };
  }

  Triangles MeasureRefined(int width) const
  {
    vtkNew<vtkAdaptiveRefinementFilter> filter;
    filter->SetInputData(this->Coarse);
    filter->SetRefinement(BenchmarkPatchMeshes::MakeRecipe(Pixels));
    filter->SetCamera(this->Camera);
    filter->SetViewportSize(width, GetHeight(width));
    filter->Update();
    return this->Measure(filter->GetOutput(), width);
  }

  // Finds the lowest sufficient level from `level` on and stores it in `level`.
  Triangles MeasureEven(int width, int& level)
  {
    Triangles even;
    for (;; ++level)
    {
      if (level != this->EvenLevel)
      {
        this->Even = BenchmarkPatchMeshes::MakeEvenSurface(this->Parted, level);
        this->EvenLevel = level;
      }
      even = this->Measure(this->Even, width);
      if (even.Error <= Pixels || level == LastLevel)
      {
        return even;
      }
    }
  }

private:
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkPolyData> Coarse;
  vtkSmartPointer<vtkUnstructuredGrid> Parted;
  vtkSmartPointer<vtkCamera> Camera;
  RelevoPatchDistance Distance;
  vtkSmartPointer<vtkPolyData> Even;
  int EvenLevel = 0;
};

std::string Format(double ratio)
{
  return std::to_string(ratio).substr(0, 5);
}
}

void AddPatchTriangles(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("patches-triangles",
    "Triangles within half a pixel of the teapot, against vtkDataSetSurfaceFilter",
    { { "zoom", "zoom", 0 }, { "width", "window", 0 }, { "triangles", "triangles", 0 },
      { "triangles_unculled", "not culled", 0 }, { "triangles_in_view", "in view", 0 },
      { "error", "off, pixels", 2 }, { "vtk_level", "level of VTK", 0 },
      { "vtk_triangles", "its triangles", 0 }, { "vtk_error", "off, pixels", 2 },
      { "ratio", "ratio", 3 }, { "ratio_unculled", "not culled / VTK's", 3 },
      { "ratio_in_view", "in view / VTK's", 3 } });
  for (const double zoom : { 1.0, 10.0 })
  {
    Contest contest(zoom, options.Quick);
    double sum = 0.0;
    double unculledSum = 0.0;
    double inViewSum = 0.0;
    int windows = 0;
    int level = 1;
    for (int width = 256; width <= (options.Quick ? 256 : 2048); width *= 2, ++windows)
    {
      const Triangles ours = contest.MeasureRefined(width);
      const Triangles even = contest.MeasureEven(width, level);
      table.AddRow({ zoom, static_cast<double>(width), ours.All, ours.Unculled, ours.InView,
        ours.Error, static_cast<double>(level), even.All, even.Error, ours.All / even.All,
        ours.Unculled / even.All, ours.InView / even.All });
      sum += std::log(ours.All / even.All);
      unculledSum += std::log(ours.Unculled / even.All);
      inViewSum += std::log(ours.InView / even.All);
    }
    table.AddNote("Geometric means at zoom " + std::to_string(static_cast<int>(zoom)) + ": " +
      Format(std::exp(sum / windows)) + ", without culled ones " +
      Format(std::exp(unculledSum / windows)) + ", of those in view " +
      Format(std::exp(inViewSum / windows)) + "; asked: " + (zoom > 1.0 ? "0.15." : "0.6."));
  }
  table.AddNote(
    "Patches are split (SplitPatchesOn). VTK: the least NonlinearSubdivisionLevel, up to " +
    std::to_string(LastLevel) +
    ", whose triangles in view are off by no more than asked, of cells that share no points; "
    "vtkPolyDataMapper draws all of them. Culled: triangles of patches out of view. Off: the "
    "largest distance of middles of triangles and of their edges from the nearest point of the "
    "patches, of about " +
    std::to_string(MeasuredTriangles) + " triangles where there are more.");
  addTable(table);
}
