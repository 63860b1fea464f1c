// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes and a metric that tell what is done with them.
#ifndef RelevoWatched_h
#define RelevoWatched_h

#include "Metrics/MetricEvaluator.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <atomic>
#include <memory>

// Counts how often tuples of any of them are read one by one, as points are by GetPoint().
class RelevoWatchedFloats : public vtkFloatArray
{
public:
  static RelevoWatchedFloats* New();
  vtkTypeMacro(RelevoWatchedFloats, vtkFloatArray);

  double* GetTuple(vtkIdType tuple) override;
  void GetTuple(vtkIdType tuple, double* values) override;

  static std::atomic<long>& GetReads();
};

// Spheres in a square, 64 unless told otherwise, whose points are watched.
vtkSmartPointer<vtkMultiBlockDataSet> MakeWatchedBlocks(int side = 8);

// Levels that fall with the distance from the camera to the middle of the mesh, which its
// evaluators keep.
class RelevoWatchedMetric : public vtkDepthTagMetric
{
public:
  static RelevoWatchedMetric* New();
  vtkTypeMacro(RelevoWatchedMetric, vtkDepthTagMetric);

  bool IsViewDependent() override { return true; }
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;

  std::atomic<int> Evaluators{ 0 };
  std::atomic<int> LivingEvaluators{ 0 };
  // How often an evaluator met a mesh that was new to it, and how often one gave tags.
  std::atomic<int> Preparations{ 0 };
  std::atomic<int> Evaluations{ 0 };
};

#endif
