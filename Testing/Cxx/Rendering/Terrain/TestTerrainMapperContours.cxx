// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// From above, contour lines are those of vtkContourFilter at full resolution, however large the
// triangles are, and have a constant width.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkContourFilter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr int Size = 700;
constexpr int Width = 300;       // of the window
constexpr double Spacing = 30.0; // metres
constexpr double Interval = 50.0;

std::string WriteHills(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, Spacing);
  raster.SetValues(
    [](int, int column, int row)
    {
      return 907.0 + 400.0 * std::sin(column / 60.0) * std::cos(row / 80.0) +
        90.0 * std::sin(column / 19.0 + row / 31.0);
    });
  const std::string file = folders.File("TerrainMapperContourHills.tif");
  CHECK(raster.Write(file));
  return file;
}

class ContourScene : public RelevoPyramidScene
{
public:
  ContourScene(const std::string& file, double metresPerPixel)
    : RelevoPyramidScene(file, Width, Width)
    , MetresPerPixel(metresPerPixel)
  {
    this->Actor->GetProperty()->LightingOff();
    this->Mapper->SetContourInterval(Interval);
    this->Mapper->SetScreenSpaceError(20.0); // large triangles
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(311.0, -207.0, 20000.0);
    camera->SetFocalPoint(311.0, -207.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * Width * metresPerPixel);
    this->Renderer->ResetCameraClippingRange();
  }

  // Returns the contour lines at full resolution, in pixels from the centre of the lower left one.
  vtkSmartPointer<vtkPolyData> MakeContours(RelevoCheck& check)
  {
    constexpr int perPixel = 4;
    constexpr int side = perPixel * (Width - 1) + 1;
    vtkNew<vtkDoubleArray> places;
    places->SetNumberOfComponents(2);
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        // The centre of the raster is the origin of the world.
        const double center = 0.5 * (Width - 1);
        const double half = 0.5 * Size * Spacing;
        places->InsertNextTuple2(500000.0 + half + 311.0 +
            (static_cast<double>(x) / perPixel - center) * this->MetresPerPixel,
          4300000.0 - half - 207.0 +
            (static_cast<double>(y) / perPixel - center) * this->MetresPerPixel);
      }
    }
    auto heights = vtk::TakeSmartPointer(this->Pyramid->GetElevations(places));
    vtkNew<vtkImageData> image;
    image->SetDimensions(side, side, 1);
    image->SetSpacing(1.0 / perPixel, 1.0 / perPixel, 1.0);
    image->GetPointData()->SetScalars(heights);
    vtkNew<vtkContourFilter> filter;
    filter->SetInputData(image);
    for (int i = 0; i < 40; ++i)
    {
      filter->SetValue(i, i * Interval);
    }
    filter->Update();
    CHECK_GREATER(filter->GetOutput()->GetNumberOfLines(), 100);
    return filter->GetOutput();
  }

  const double MetresPerPixel;
};

struct Distances
{
  double Drawn = 0.0;   // of the centres of covered pixels from lines, in pixels
  double Missing = 0.0; // the fraction of the lines that have no covered pixel beside them
  double Width = 0.0;   // mean
};

Distances Measure(const RelevoPicture& picture, vtkPolyData* contours)
{
  const auto getCoverage = [&picture](int x, int y)
  { return 1.0 - picture.Colors[3 * (static_cast<size_t>(y) * Width + x)] / 255.0; };
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(contours);
  locator->BuildLocator();
  Distances result;
  double covered = 0.0;
  constexpr int border = 4;
  for (int y = border; y < Width - border; ++y)
  {
    for (int x = border; x < Width - border; ++x)
    {
      covered += getCoverage(x, y);
      if (getCoverage(x, y) > 0.5)
      {
        const double pixel[3] = { static_cast<double>(x), static_cast<double>(y), 0.0 };
        double nearest[3];
        vtkIdType cell;
        int part;
        double squared;
        locator->FindClosestPoint(pixel, nearest, cell, part, squared);
        result.Drawn = std::max(result.Drawn, std::sqrt(squared));
      }
    }
  }
  double length = 0.0;
  double missing = 0.0;
  for (vtkIdType i = 0; i < contours->GetNumberOfCells(); ++i)
  {
    double ends[2][3];
    contours->GetPoint(contours->GetCell(i)->GetPointId(0), ends[0]);
    contours->GetPoint(contours->GetCell(i)->GetPointId(1), ends[1]);
    const int x = static_cast<int>(std::lround(0.5 * (ends[0][0] + ends[1][0])));
    const int y = static_cast<int>(std::lround(0.5 * (ends[0][1] + ends[1][1])));
    if (std::min(x, y) < border || std::max(x, y) >= Width - border)
    {
      continue;
    }
    const double part = std::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    length += part;
    double best = 0.0;
    for (int k = 0; k < 9; ++k)
    {
      best = std::max(best, getCoverage(x + k % 3 - 1, y + k / 3 - 1));
    }
    missing += best > 0.3 ? 0.0 : part;
  }
  result.Missing = missing / length;
  result.Width = covered / length;
  return result;
}
}

int TestTerrainMapperContours(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = WriteHills(check, folders);
  for (double samplesPerPixel : { 0.125, 0.5, 1.0, 1.7 })
  {
    CHECK_CASE(samplesPerPixel);
    ContourScene scene(file, samplesPerPixel * Spacing);
    for (double width : { 1.0, 2.0 })
    {
      CHECK_CASE(width);
      scene.Mapper->SetContourWidth(width);
      const RelevoPicture picture = scene.Draw();
      picture.Save(
        folders.File("TerrainMapperContours" + std::to_string(samplesPerPixel) + ".png"));
      const Distances distances = Measure(picture, scene.MakeContours(check));
      std::cout << samplesPerPixel << " samples per pixel, width " << width << ": "
                << distances.Drawn << " pixels, missing " << distances.Missing << ", width "
                << distances.Width << "\n";
      CHECK_LESS(distances.Drawn, 0.5 * width + 0.6);
      CHECK_LESS(distances.Missing, 0.002);
      CHECK_NEAR(distances.Width, width, 0.06 * width);
    }
  }
  return check.GetResult();
}
