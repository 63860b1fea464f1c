// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPatchPictures.h"

#include "BenchmarkPatchMeshes.h"
#include "BenchmarkPatchReference.h"
#include "BenchmarkPatchWay.h"
#include "BenchmarkPixelPoints.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace
{
using Policy = BenchmarkPatchWay;

struct Picture
{
  std::vector<unsigned char> Colors;
  std::vector<float> Depths;
};

Picture Draw(BenchmarkView& view, vtkMapper* mapper)
{
  const auto actor = view.AddActor(mapper);
  actor->GetProperty()->LightingOff();
  view.TimeFrame();
  Picture picture = { view.GetPicture(), view.GetDepths() };
  view.GetRenderer()->RemoveActor(actor);
  return picture;
}

// Whether a pixel or one of its neighbours is background.
bool IsOutline(BenchmarkView& view, const Picture& picture, int pixel)
{
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      const int column = pixel % view.GetWidth() + x;
      const int row = pixel / view.GetWidth() + y;
      const bool isInside =
        column >= 0 && column < view.GetWidth() && row >= 0 && row < view.GetHeight();
      if (isInside && picture.Depths[row * view.GetWidth() + column] >= 1.0f)
      {
        return true;
      }
    }
  }
  return false;
}

struct Reference
{
  std::vector<int> Pixels; // their rays hit a cell
  std::vector<unsigned char> Colors;
  double Tried = 0.0; // pixels
};

Reference FindColors(
  BenchmarkView& view, const Picture& picture, vtkUnstructuredGrid* grid, vtkScalarsToColors* table)
{
  BenchmarkPatchReference cells(grid);
  const BenchmarkPixelPoints points(view);
  std::array<double, 3> eye;
  view.GetRenderer()->GetActiveCamera()->GetPosition(eye.data());
  Reference reference;
  for (int pixel = 0; pixel < points.GetNumberOfPixels(); ++pixel)
  {
    if (!IsOutline(view, picture, pixel))
    {
      ++reference.Tried;
      const auto point = points.Get(pixel, picture.Depths[pixel]);
      const double value = cells.FindValue(eye, point);
      if (std::isfinite(value))
      {
        reference.Pixels.push_back(pixel);
        const unsigned char* color = table->MapValue(value);
        reference.Colors.insert(reference.Colors.end(), color, color + 3);
      }
    }
  }
  return reference;
}

struct Agreement
{
  double Near = 0.0; // share of the reference's pixels within 2 of 255
  double Quantile = 0.0;
  double Largest = 0.0;
};

Agreement Compare(const Picture& picture, const Reference& reference)
{
  std::vector<int> differences;
  for (size_t i = 0; i < reference.Pixels.size(); ++i)
  {
    int largest = 0;
    for (size_t c = 0; c < 3; ++c)
    {
      largest = std::max(largest,
        std::abs(picture.Colors[3 * static_cast<size_t>(reference.Pixels[i]) + c] -
          reference.Colors[3 * i + c]));
    }
    differences.push_back(largest);
  }
  std::sort(differences.begin(), differences.end());
  const auto end = std::upper_bound(differences.begin(), differences.end(), 2);
  const auto number = static_cast<double>(differences.size());
  return { static_cast<double>(end - differences.begin()) / number,
    static_cast<double>(differences[static_cast<size_t>(0.999 * (number - 1.0))]),
    static_cast<double>(differences.back()) };
}
}

void AddPatchPictures(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("patches-pictures", "Colours against vtkCell's own interpolation",
    { { "way", "way", 0 }, { "pixels", "pixels", 0 }, { "near_percent", "within 2 of 255, %", 2 },
      { "quantile", "99.9 %", 0 }, { "largest", "largest", 0 } });
  const auto grid = BenchmarkPatchMeshes::MakeHexahedra(options.Quick ? 3 : 16);
  BenchmarkView view(options.Quick ? 64 : 1024, options.Quick ? 48 : 768);
  view.LookAt(grid->GetBounds());
  Reference reference;
  for (const Policy::Kind kind : { Policy::Exact, Policy::Linear, Policy::Even })
  {
    const Policy way(kind, grid);
    const Picture picture = Draw(view, way.GetMapper());
    if (reference.Pixels.empty())
    {
      reference = FindColors(view, picture, grid, way.GetMapper()->GetLookupTable());
    }
    const Agreement agreement = Compare(picture, reference);
    table.AddRow({ Policy::GetName(kind), static_cast<double>(reference.Pixels.size()),
      100.0 * agreement.Near, agreement.Quantile, agreement.Largest });
  }
  table.AddNote(
    "Half a pixel, no light. The reference: where the ray of a pixel meets the outer "
    "face of a cell (EvaluateLocation() and Newton's method), its interpolation, and "
    "the lookup table. Pixels at the outline are left out, and those whose ray meets none: " +
    std::to_string(static_cast<int>(reference.Tried) - static_cast<int>(reference.Pixels.size())) +
    ". Asked: 99.9 % of pixels.");
  addTable(table);
}
