// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CandidateMetrics
 * @brief   the metrics that have the boxes of actors that may meet
 */
#ifndef CandidateMetrics_h
#define CandidateMetrics_h

#include "Scene/SceneActor.h"
#include "vtkProximityDepthTagMetric.h" // for members
#include "vtkSmartPointer.h"            // for members
#include "vtkWeakPointer.h"             // for members

#include <map>    // for members
#include <vector> // for members

namespace relevo
{
class CandidateMetrics
{
public:
  /// No boxes yet. Metrics that are made have this distance.
  void Begin(double distance);
  /// An actor whose metric is to be kept, made where there can be one and none is.
  void AddActor(vtkActor* actor);
  void AddBox(vtkActor* actor, const Bounds& box);
  /// Give the metrics their boxes, and those of actors that are gone none.
  void End();

private:
  using Metric = vtkSmartPointer<vtkProximityDepthTagMetric>;

  double Distance = 0.0;
  std::vector<vtkWeakPointer<vtkProximityDepthTagMetric>> Made;
  std::map<vtkActor*, Metric> Metrics;
  std::map<Metric, std::vector<Bounds>> Boxes;
  std::map<Metric, std::vector<Bounds>> Before;
};
}

#endif
