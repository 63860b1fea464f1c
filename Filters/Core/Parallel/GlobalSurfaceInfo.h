// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobalSurfaceInfo
 * @brief   values of the whole surface that a mesh is a piece of
 *
 * A mesh without this information is the whole surface.
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
  /// The box of all points.
  FiniteBox PointBox;
  /// The box of the triangles' corners, or of all points if there are no triangles.
  FiniteBox CornerBox;
  /// Whether displacement uses separate directions, see RefinementMesh::Directions.
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
