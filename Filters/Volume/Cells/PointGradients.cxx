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
constexpr size_t BatchSize = 1 << 14;

struct Share
{
  Gradients Gradient;
  double Volume;
};

Share ComputeShare(const VolumeCells& cells, const VolumeCells::Cell& cell, int numberOfComponents)
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
    share.Gradient = cells.ComputeGradients(cell, slopes, numberOfComponents);
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
  const std::vector<dvec3> all =
    ComputePointGradients(cells, MergeCellPoints(cells), MaximumComponents);
  std::vector<Gradients> gradients(cells.GetPoints().size());
  for (size_t i = 0; i < gradients.size(); ++i)
  {
    std::copy_n(all.begin() + MaximumComponents * i, MaximumComponents, gradients[i].begin());
  }
  return gradients;
}

// Gradients are summed in the order of cells, so that the number of threads has no effect.
std::vector<dvec3> ComputePointGradients(
  const VolumeCells& cells, const MergedCellPoints& merged, int numberOfComponents)
{
  const size_t own = cells.GetCells().size();
  const size_t number = own + cells.GetGhosts().size();
  const auto get = [&](size_t i)
  { return i < own ? cells.GetCells()[i] : cells.GetGhosts()[i - own]; };
  const size_t width = static_cast<size_t>(numberOfComponents);
  const size_t numberOfPoints = cells.GetPoints().size();
  std::vector<dvec3> gradients(width * numberOfPoints, dvec3(0.0));
  std::vector<double> volumes(numberOfPoints, 0.0);
  std::vector<Share> batch(std::min(BatchSize, number));
  for (size_t begin = 0; begin < number; begin += BatchSize)
  {
    const size_t count = std::min(BatchSize, number - begin);
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          batch[i] = ComputeShare(cells, get(begin + i), numberOfComponents);
        }
      });
    for (size_t i = 0; i < count; ++i)
    {
      const VolumeCells::Cell cell = get(begin + i);
      for (int corner = 0; corner < cells.GetNumberOfCorners(cell); ++corner)
      {
        const auto point = static_cast<size_t>(merged.GetPoint(cells.GetCornerId(cell, corner)));
        volumes[point] += batch[i].Volume;
        for (size_t c = 0; c < width; ++c)
        {
          gradients[width * point + c] += batch[i].Gradient[c];
        }
      }
    }
  }
  // Points follow the point that they are merged with.
  for (size_t i = 0; i < numberOfPoints; ++i)
  {
    const auto point = static_cast<size_t>(merged.GetPoint(static_cast<vtkIdType>(i)));
    for (size_t c = 0; c < width; ++c)
    {
      dvec3& gradient = gradients[width * i + c];
      gradient = point != i ? gradients[width * point + c]
        : volumes[i] > 0.0  ? gradient / volumes[i]
                            : dvec3(0.0);
    }
  }
  return gradients;
}
}
