// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::MetricEvaluator
 * @brief   a depth-tag metric evaluated for one mesh
 *
 * A metric holds parameters; what it computes of a mesh is held by its evaluator for that mesh,
 * which belongs to the mapper or filter that refines the mesh. So one metric serves any number of
 * meshes, and mappers and filters in several threads. An evaluator looks at its metric's parameters
 * whenever it is asked, and is to be used by one thread at a time.
 *
 * Made by vtkDepthTagMetric::NewEvaluator(). Its functions are those of vtkDepthTagMetric.
 */
#ifndef MetricEvaluator_h
#define MetricEvaluator_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"             // for members
#include "vtkSmartPointer.h"               // for members

#include <memory> // for members
#include <vector> // for numbers

class vtkFloatArray;

namespace relevo
{
struct MetricShader;
struct RefinementView;
class MetricMesh;
class PieceReduction;
struct GlobalSurfaceInfo;

class RELEVOFILTERSREFINEMENT_EXPORT MetricEvaluator
{
public:
  MetricEvaluator(const MetricEvaluator&) = delete;
  void operator=(const MetricEvaluator&) = delete;
  virtual ~MetricEvaluator();

  /// See vtkDepthTagMetric::ComputeTags().
  virtual bool ComputeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) = 0;

  /// See vtkDepthTagMetric::ComputeEdgeTags(); the edges are those of the mesh. Unless overridden,
  /// an edge has the mean of the tags of its two places.
  virtual bool ComputeEdgeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags);

  /// See vtkDepthTagMetric::GetShader(). Unless overridden, there is none.
  virtual bool GetShader(
    const RefinementView& view, int maximumLevel, const double origin[3], MetricShader& shader);

  /// Have the numbers that this metric, and those that it is made of, need of the whole surface
  /// that the mesh is a piece of. Collective. Unless overridden, those of ComputeNumbers().
  virtual void ShareNumbers(
    const RefinementView& view, const PieceReduction& pieces, GlobalSurfaceInfo& whole);

  /// The metric, which lives as long as its evaluators.
  vtkDepthTagMetric* GetMetric() const { return this->Metric; }
  /// The mesh, as it is.
  MetricMesh& GetMesh() const { return *this->Mesh; }

protected:
  MetricEvaluator(vtkDepthTagMetric* metric, std::shared_ptr<MetricMesh> mesh);

  /// Numbers of a whole surface that tags depend on, as quantiles, from all its pieces. Collective,
  /// and silent where tags are an error. Unless overridden there are none.
  virtual std::vector<double> ComputeNumbers(
    const RefinementView& view, const PieceReduction& pieces);

  /// Those of the whole that the mesh is a piece of; without one, those of the mesh.
  std::vector<double> GetNumbers(const RefinementView& view);

private:
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  std::shared_ptr<MetricMesh> Mesh;
};

/// The metric's own evaluator; if it has none, one that asks the metric itself.
RELEVOFILTERSREFINEMENT_EXPORT std::unique_ptr<MetricEvaluator> MakeEvaluator(
  vtkDepthTagMetric* metric, const std::shared_ptr<MetricMesh>& mesh);
}

#endif
