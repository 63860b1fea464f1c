// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CandidateMetrics
 * @brief   the metrics that get the boxes of actors that may touch
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
  /// Start without boxes. Created metrics get this distance.
  void Begin(double distance);
  /// Add an actor, and create its metric if it has none and can have one.
  void AddActor(vtkActor* actor);
  void AddBox(vtkActor* actor, const Bounds& box);
  /// Set the boxes of the metrics, and remove those of removed actors.
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
