// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatchScene.h"

#include "RelevoPatches.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPatchSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Width = 300;
constexpr double Shown = 1.2;

void AddArray(vtkUnstructuredGrid* grid, vtkDataArray* array, const char* name, int components,
  const std::function<double(double, double, int)>& value)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* x = grid->GetCell(0)->GetParametricCoords() + 3 * i;
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, value(x[0], x[1], c));
    }
  }
  grid->GetPointData()->AddArray(array);
}

// Finds a point in a flat cell by Newton's method, and the weights of its nodes.
bool FindPlace(vtkCell* cell, const std::array<double, 2>& place, std::vector<double>& weights)
{
  constexpr double step = 1e-5;
  int subId = 0;
  double rs[3] = { place[0], place[1], 0.0 };
  double x[3];
  const auto evaluate = [&](double r, double s)
  {
    const double at[3] = { r, s, 0.0 };
    cell->EvaluateLocation(subId, at, x, weights.data());
  };
  for (int i = 0; i < 20; ++i)
  {
    evaluate(rs[0] + step, rs[1]);
    const double r[2] = { x[0], x[1] };
    evaluate(rs[0], rs[1] + step);
    const double s[2] = { x[0], x[1] };
    evaluate(rs[0], rs[1]);
    const double f[2] = { x[0] - place[0], x[1] - place[1] };
    if (std::abs(f[0]) + std::abs(f[1]) < 1e-12)
    {
      return true;
    }
    const double j[4] = { (r[0] - x[0]) / step, (s[0] - x[0]) / step, (r[1] - x[1]) / step,
      (s[1] - x[1]) / step };
    const double determinant = j[0] * j[3] - j[1] * j[2];
    rs[0] -= (j[3] * f[0] - j[1] * f[1]) / determinant;
    rs[1] -= (j[0] * f[1] - j[2] * f[0]) / determinant;
  }
  return false;
}
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoNewFlatCell(
  int type, const std::array<int, 3>& degrees, double share, bool isRational)
{
  auto grid = RelevoNewCell(type, degrees, share, isRational);
  const bool isTriangle = grid->GetCell(0)->GetNumberOfEdges() == 3;
  const double* parametric = grid->GetCell(0)->GetParametricCoords();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    const double r = parametric[3 * i];
    const double s = parametric[3 * i + 1];
    const double high = isTriangle ? r + s : std::max(r, s);
    const bool isInside = std::min(r, s) > 1e-9 && high < 1.0 - 1e-9;
    grid->GetPoints()->SetPoint(i, isInside ? x[0] : r, isInside ? x[1] : s, 0.0);
  }
  vtkNew<vtkDoubleArray> field;
  AddArray(grid, field, "Field", 1,
    [](double r, double s, int) { return std::sin(5.0 * r + 2.0 * s) * (0.5 + 0.5 * s); });
  vtkNew<vtkDoubleArray> vectors;
  AddArray(grid, vectors, "Vector", 3,
    [](double r, double s, int c) { return std::cos(2.0 * r + s * (c + 1)) + 0.25 * c; });
  vtkNew<vtkDoubleArray> five;
  AddArray(
    grid, five, "Long", 5, [](double r, double s, int c) { return std::cos(0.5 * r * c + s) - r; });
  vtkNew<vtkUnsignedCharArray> colors;
  AddArray(grid, colors, "Color", 3,
    [](double r, double s, int c) { return 128.0 + 100.0 * std::sin(4.0 * r * (c + 1) + s); });
  vtkNew<vtkIntArray> whole;
  AddArray(grid, whole, "Whole", 1,
    [](double r, double s, int) { return std::round(10.0 + 10.0 * std::sin(6.0 * r - 3.0 * s)); });
  grid->GetPointData()->SetActiveScalars("Field");
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoNewFlatGrid(int n, int m)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> field;
  field->SetName("Field");
  for (int j = 0; j <= m; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points->InsertNextPoint(i, j, 0.0);
      field->InsertNextValue(i);
    }
  }
  grid->SetPoints(points);
  grid->Allocate(n * m);
  for (vtkIdType j = 0; j < m; ++j)
  {
    for (vtkIdType i = 0; i < n; ++i)
    {
      const vtkIdType low = j * (n + 1) + i;
      const vtkIdType ids[4] = { low, low + 1, low + n + 2, low + n + 1 };
      grid->InsertNextCell(VTK_QUAD, 4, ids);
    }
  }
  grid->GetPointData()->SetScalars(field);
  return grid;
}

RelevoPatchScene::RelevoPatchScene(vtkDataObject* input, double size)
  : Size(size)
{
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Width, Width);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(1.0, 0.0, 1.0);
  this->Mapper->SetInputDataObject(input);
  vtkNew<vtkPatchSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(surface);
  recipe->SetMaximumLevel(7);
  this->Mapper->SetRefinement(recipe);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(this->Actor);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * Shown * size);
  camera->SetFocalPoint(0.5 * size, 0.5 * size, 0.0);
  camera->SetPosition(0.5 * size, 0.5 * size, 1.0);
}

RelevoPicture RelevoPatchScene::Draw()
{
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
  return RelevoPicture(this->Window);
}

std::array<double, 2> RelevoPatchScene::GetPosition(int x, int y) const
{
  const double low = -0.5 * (Shown - 1.0);
  return { { this->Size * (low + Shown * (x + 0.5) / Width),
    this->Size * (low + Shown * (y + 0.5) / Width) } };
}

double RelevoPatchScene::GetShareOfOthers(
  vtkUnstructuredGrid* grid, const char* array, const std::function<Color(const Tuple&)>& toColor)
{
  const RelevoPicture picture = this->Draw();
  vtkDataArray* values = grid->GetPointData()->GetArray(array);
  vtkCell* cell = grid->GetCell(0);
  std::vector<double> weights(static_cast<size_t>(grid->GetNumberOfPoints()));
  const double margin = 2.0 * Shown / Width;
  const bool isTriangle = cell->GetNumberOfEdges() == 3;
  int pixels = 0;
  int others = 0;
  for (int y = 0; y < Width; ++y)
  {
    // Tests a quarter of the pixels in all columns, because VTK is slow to find points in cells.
    for (int x = 2 * y % 4 + y / 2 % 2; x < Width; x += 4)
    {
      const std::array<double, 2> place = this->GetPosition(x, y);
      const double high =
        isTriangle ? place[0] + place[1] + margin : std::max(place[0], place[1]) + margin;
      if (std::min(place[0], place[1]) < margin || high > 1.0 || !FindPlace(cell, place, weights))
      {
        continue;
      }
      Tuple tuple(static_cast<size_t>(values->GetNumberOfComponents()), 0.0);
      for (size_t i = 0; i < weights.size(); ++i)
      {
        for (size_t c = 0; c < tuple.size(); ++c)
        {
          tuple[c] +=
            weights[i] * values->GetComponent(static_cast<vtkIdType>(i), static_cast<int>(c));
        }
      }
      const Color expected = toColor(tuple);
      const unsigned char* color = &picture.Colors[3 * (static_cast<size_t>(y) * Width + x)];
      ++pixels;
      others += std::abs(color[0] - expected[0]) > 2.0 || std::abs(color[1] - expected[1]) > 2.0 ||
        std::abs(color[2] - expected[2]) > 2.0;
    }
  }
  return pixels < 1000 ? 1.0 : static_cast<double>(others) / pixels;
}

std::function<RelevoPatchScene::Color(const RelevoPatchScene::Tuple&)> RelevoPatchScene::ByTable(
  const std::function<double(const Tuple&)>& number)
{
  return [this, number](const Tuple& tuple)
  {
    const unsigned char* color = this->Mapper->GetLookupTable()->MapValue(number(tuple));
    return Color{ static_cast<double>(color[0]), static_cast<double>(color[1]),
      static_cast<double>(color[2]) };
  };
}
