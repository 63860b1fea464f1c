// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/PointGradients.h"

#include "Cells/MergedCellPoints.h"
#include "Cells/VolumeCells.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Number of cells whose gradients are in memory at a time.
constexpr size_t BatchSize = 1 << 16;

struct Share
{
  Gradients Gradient;
  double Volume;
};

Share ComputeShare(const VolumeCells& cells, const VolumeCells::Cell& cell)
{
  Share share = { {}, 0.0 };
  if (cell.Scalars < 0)
  {
    CornerSlopes slopes;
    if (cell.Shape)
    {
      const CurvedCell curved = cells.GetCurved(cell);
      share.Volume = cell.Shape->Volume * curved.ComputeSlopes(curved.GetCenter(), slopes);
    }
    else
    {
      share.Volume = ComputeSlopes(cells.GetTetrahedron(cell), slopes) / 6.0;
    }
    share.Gradient = cells.ComputeGradients(cell, slopes);
  }
  for (dvec3& gradient : share.Gradient)
  {
    gradient *= share.Volume;
    const double size = dot(gradient, gradient);
    if (!std::isfinite(size))
    {
      return { {}, 0.0 };
    }
  }
  return share;
}
}

std::vector<Gradients> ComputePointGradients(const VolumeCells& cells)
{
  return ComputePointGradients(cells, MergeCellPoints(cells).Points);
}

// Gradients are summed in the order of cells, so that the number of threads has no effect.
std::vector<Gradients> ComputePointGradients(
  const VolumeCells& cells, const std::vector<vtkIdType>& merged)
{
  const size_t own = cells.GetCells().size();
  const size_t number = own + cells.GetGhosts().size();
  const auto get = [&](size_t i) -> const VolumeCells::Cell&
  { return i < own ? cells.GetCells()[i] : cells.GetGhosts()[i - own]; };
  std::vector<Gradients> gradients(merged.size());
  std::vector<double> volumes(merged.size(), 0.0);
  std::vector<Share> batch(std::min(BatchSize, number));
  for (size_t begin = 0; begin < number; begin += BatchSize)
  {
    const size_t count = std::min(BatchSize, number - begin);
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          batch[i] = ComputeShare(cells, get(begin + i));
        }
      });
    for (size_t i = 0; i < count; ++i)
    {
      const VolumeCells::Cell& cell = get(begin + i);
      for (int corner = 0; corner < cells.GetNumberOfCorners(cell); ++corner)
      {
        const vtkIdType point = merged[cells.GetCornerId(cell, corner)];
        volumes[point] += batch[i].Volume;
        for (size_t c = 0; c < gradients[point].size(); ++c)
        {
          gradients[point][c] += batch[i].Gradient[c];
        }
      }
    }
  }
  // Points follow the point that they are merged with.
  for (size_t i = 0; i < gradients.size(); ++i)
  {
    if (merged[i] != static_cast<vtkIdType>(i))
    {
      gradients[i] = gradients[merged[i]];
      continue;
    }
    for (dvec3& gradient : gradients[i])
    {
      gradient = volumes[i] > 0.0 ? gradient / volumes[i] : dvec3(0.0);
    }
  }
  return gradients;
}
}
