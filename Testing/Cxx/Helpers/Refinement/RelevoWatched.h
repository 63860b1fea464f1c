// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes and a metric that count how they are used.
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

// Counts calls that read single tuples of such arrays, like GetPoint().
class RelevoWatchedFloats : public vtkFloatArray
{
public:
  static RelevoWatchedFloats* New();
  vtkTypeMacro(RelevoWatchedFloats, vtkFloatArray);

  double* GetTuple(vtkIdType tuple) override;
  void GetTuple(vtkIdType tuple, double* values) override;

  static std::atomic<long>& GetReads();
};

// Spheres in a square of side x side, whose points count reads.
vtkSmartPointer<vtkMultiBlockDataSet> MakeWatchedBlocks(int side = 8);

// Levels that decrease with the distance from the camera to the centre of the mesh, which
// evaluators cache.
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
  // Number of times an evaluator prepared a new mesh, and number of evaluations.
  std::atomic<int> Preparations{ 0 };
  std::atomic<int> Evaluations{ 0 };
};

#endif
