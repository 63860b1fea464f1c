// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatchFiles.h"

#include <algorithm>
#include <istream>
#include <sstream>

namespace
{
RelevoPosition Construct(std::vector<RelevoPosition> points, double t)
{
  while (points.size() > 1)
  {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        points[i][axis] = (1.0 - t) * points[i][axis] + t * points[i + 1][axis];
      }
    }
    points.pop_back();
  }
  return points[0];
}
}

RelevoPosition RelevoPatch::Evaluate(double u, double v) const
{
  std::vector<RelevoPosition> curve;
  const int width = this->Second + 1;
  for (int i = 0; i <= this->First; ++i)
  {
    const auto row = this->Points.begin() + static_cast<std::ptrdiff_t>(i) * width;
    curve.push_back(Construct({ row, row + width }, v));
  }
  return Construct(curve, u);
}

std::vector<RelevoPatch> RelevoReadPatches(std::istream& text)
{
  std::size_t number = 0;
  text >> number;
  std::vector<RelevoPatch> patches(number);
  for (RelevoPatch& patch : patches)
  {
    text >> patch.First >> patch.Second;
    patch.Points.resize(static_cast<std::size_t>(patch.First + 1) * (patch.Second + 1));
    for (RelevoPosition& point : patch.Points)
    {
      text >> point[0] >> point[1] >> point[2];
    }
  }
  return patches;
}

std::string RelevoWritePatches(const std::vector<RelevoPatch>& patches)
{
  std::ostringstream text;
  text.precision(17);
  text << patches.size() << "\n";
  for (const RelevoPatch& patch : patches)
  {
    text << patch.First << " " << patch.Second << "\n";
    for (const RelevoPosition& point : patch.Points)
    {
      text << point[0] << " " << point[1] << " " << point[2] << "\n";
    }
  }
  return text.str();
}

double RelevoGetPatchError(vtkUnstructuredGrid* grid, const std::vector<RelevoPatch>& patches)
{
  constexpr int steps = 8;
  double error = 0.0;
  for (std::size_t cell = 0; cell < patches.size(); ++cell)
  {
    for (int k = 0; k < (steps + 1) * (steps + 1); ++k)
    {
      const double u = k % (steps + 1) / static_cast<double>(steps);
      const double v = k / (steps + 1) / static_cast<double>(steps);
      error = std::max(error,
        RelevoGetDistance(RelevoEvaluateCell(grid, static_cast<vtkIdType>(cell), u, v),
          patches[cell].Evaluate(v, u)));
    }
  }
  return error;
}
