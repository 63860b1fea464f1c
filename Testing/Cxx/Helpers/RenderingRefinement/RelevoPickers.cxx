// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPickers.h"

#include "vtkCellData.h"
#include "vtkMath.h"

#include <cmath>
#include <iostream>
#include <random>

namespace RelevoPickers
{
void DrawFromFront(RelevoScene& scene, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  scene.Add(mesh, recipe);
  scene.MoveCamera = [](vtkCamera*) {};
  scene.ResetCameras();
  scene.Render();
}

std::array<double, 2> ToDisplay(vtkRenderer* renderer, double x, double y, double z)
{
  renderer->SetWorldPoint(x, y, z, 1.0);
  renderer->WorldToDisplay();
  const double* display = renderer->GetDisplayPoint();
  return { { display[0], display[1] } };
}

double GetLength(vtkRenderer* renderer)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  return std::sqrt(std::pow(bounds[1] - bounds[0], 2.0) + std::pow(bounds[3] - bounds[2], 2.0) +
    std::pow(bounds[5] - bounds[4], 2.0));
}

vtkIdType GetInputCell(vtkCellPicker* picker)
{
  if (!picker->GetDataSet())
  {
    return -1; // a clipping plane
  }
  vtkDataArray* ids = picker->GetDataSet()->GetCellData()->GetArray("vtkOriginalCellIds");
  return ids ? static_cast<vtkIdType>(ids->GetTuple1(picker->GetCellId())) : picker->GetCellId();
}

int Compare(RelevoScene& refining, RelevoScene& twin, int lines, const std::string& name,
  const Tolerance& tolerance, const std::function<void(vtkCellPicker*)>& setUp, const Check& more)
{
  std::mt19937 random(3);
  const auto number = [&random]() { return random() / 4294967296.0; };
  const int* size = refining.Renderer->GetSize();
  const double length = GetLength(twin.Renderer);
  vtkNew<vtkCellPicker> picker;
  vtkNew<vtkCellPicker> oracle;
  if (setUp)
  {
    setUp(picker);
    setUp(oracle);
  }
  int hits = 0;
  int differing = 0;
  for (int i = 0; i < lines; ++i)
  {
    const double x = size[0] * number();
    const double y = size[1] * number();
    const int found = picker->Pick(x, y, 0.0, refining.Renderer);
    const int expected = oracle->Pick(x, y, 0.0, twin.Renderer);
    std::string what;
    if (found != expected)
    {
      what = found ? "hits nothing" : "misses";
    }
    else if (found)
    {
      ++hits;
      double* p = picker->GetPickPosition();
      double* q = oracle->GetPickPosition();
      double* n = picker->GetPickNormal();
      double* m = oracle->GetPickNormal();
      what = std::sqrt(vtkMath::Distance2BetweenPoints(p, q)) > tolerance.Position * length
        ? "another place, " +
          std::to_string(std::sqrt(vtkMath::Distance2BetweenPoints(p, q)) / length)
        : std::sqrt(vtkMath::Distance2BetweenPoints(n, m)) > tolerance.Normal
        ? "another normal, " + std::to_string(std::sqrt(vtkMath::Distance2BetweenPoints(n, m)))
        : GetInputCell(picker) != GetInputCell(oracle) ? "another cell, " +
          std::to_string(GetInputCell(picker)) + " not " + std::to_string(GetInputCell(oracle))
        : more && !more(picker, oracle) ? "other data"
                                        : "";
    }
    if (!what.empty() && ++differing > tolerance.Lines)
    {
      std::cerr << name << ": the line through " << x << ", " << y << ": " << what << "\n";
    }
  }
  return differing > tolerance.Lines ? -1 : hits;
}
}
