// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's pickers on a scene and on its twin, which draws what vtkAdaptiveRefinementFilter makes.
#ifndef RelevoPickers_h
#define RelevoPickers_h

#include "RelevoScene.h"

#include "vtkCellData.h"
#include "vtkCellPicker.h"
#include "vtkMath.h"

#include <functional>
#include <random>
#include <string>

namespace RelevoPickers
{
// How many of the lines may differ: those that graze an outline within rounding.
struct Tolerance
{
  double Position = 1e-5; // of the length of what is seen
  double Normal = 1e-4;
  int Lines = 0;
};

inline double GetLength(vtkRenderer* renderer)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  return std::sqrt(std::pow(bounds[1] - bounds[0], 2.0) + std::pow(bounds[3] - bounds[2], 2.0) +
    std::pow(bounds[5] - bounds[4], 2.0));
}

// The input's cell that a pick on either scene has found.
inline vtkIdType GetInputCell(vtkCellPicker* picker)
{
  if (!picker->GetDataSet())
  {
    return -1; // a clipping plane
  }
  vtkDataArray* ids = picker->GetDataSet()->GetCellData()->GetArray("vtkOriginalCellIds");
  return ids ? static_cast<vtkIdType>(ids->GetTuple1(picker->GetCellId())) : picker->GetCellId();
}

using Check = std::function<bool(vtkCellPicker*, vtkCellPicker*)>;

// Picks both scenes, whose cameras are the same, along random lines. Returns how many hit, or -1
// where they differ. `more` is asked of lines that hit.
inline int Compare(RelevoScene& refining, RelevoScene& twin, int lines, const std::string& name,
  const Tolerance& tolerance = Tolerance(), const std::function<void(vtkCellPicker*)>& setUp = {},
  const Check& more = {})
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

#endif
