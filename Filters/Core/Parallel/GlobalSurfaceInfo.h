// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobalSurfaceInfo
 * @brief   what a mesh is told of the surface that it is a piece of
 *
 * A mesh that is told nothing is the whole.
 */
#ifndef GlobalSurfaceInfo_h
#define GlobalSurfaceInfo_h

#include "Mathematics/FiniteBox.h" // for members

#include <map>    // for members
#include <vector> // for members

class vtkDepthTagMetric;

namespace relevo
{
struct GlobalSurfaceInfo
{
  /// Of all points.
  FiniteBox PointBox;
  /// Of the corners of triangles; of all points where there are none.
  FiniteBox CornerBox;
  /// Whether displacement goes along directions of its own, see RefinementMesh::Directions.
  bool HasDirections = false;
  /// The numbers of metrics, see MetricEvaluator::ComputeNumbers().
  std::map<const vtkDepthTagMetric*, std::vector<double>> Numbers;

  bool operator==(const GlobalSurfaceInfo& other) const
  {
    return this->PointBox == other.PointBox && this->CornerBox == other.CornerBox &&
      this->HasDirections == other.HasDirections && this->Numbers == other.Numbers;
  }
};
}

#endif
