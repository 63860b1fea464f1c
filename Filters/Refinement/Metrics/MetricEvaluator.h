// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::MetricEvaluator
 * @brief   evaluates a depth-tag metric for one mesh
 *
 * A metric stores parameters. The evaluator stores the results for one mesh and belongs to the
 * mapper or filter that refines the mesh. One metric can therefore serve many meshes, and mappers
 * and filters in several threads. An evaluator reads the metric's parameters at each call. It is
 * not thread-safe.
 *
 * vtkDepthTagMetric::NewEvaluator() creates it. Its functions correspond to those of
 * vtkDepthTagMetric.
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

  /// See vtkDepthTagMetric::ComputeEdgeTags(); the edges are those of the mesh. By default, the tag
  /// of an edge is the mean of the tags of its two merged points.
  virtual bool ComputeEdgeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags);

  /// See vtkDepthTagMetric::GetShader(). By default, the shader is empty.
  virtual bool GetShader(
    const RefinementView& view, int maximumLevel, const double origin[3], MetricShader& shader);

  /// Exchange the numbers of the whole surface that this metric and the metrics it contains need,
  /// if the mesh is a piece of a distributed surface. Collective. By default, uses
  /// ComputeNumbers().
  virtual void ShareNumbers(
    const RefinementView& view, const PieceReduction& pieces, GlobalSurfaceInfo& whole);

  /// The metric, which lives at least as long as its evaluators.
  vtkDepthTagMetric* GetMetric() const { return this->Metric; }
  MetricMesh& GetMesh() const { return *this->Mesh; }

protected:
  MetricEvaluator(vtkDepthTagMetric* metric, std::shared_ptr<MetricMesh> mesh);

  /// Compute numbers of the whole surface that tags depend on, such as quantiles, from all its
  /// pieces. Collective. Reports no error if tags cannot be computed. By default, there are no
  /// numbers.
  virtual std::vector<double> ComputeNumbers(
    const RefinementView& view, const PieceReduction& pieces);

  /// The numbers of the whole surface if the mesh is a piece, otherwise those of the mesh.
  std::vector<double> GetNumbers(const RefinementView& view);

private:
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  std::shared_ptr<MetricMesh> Mesh;
};

/// Create the metric's evaluator, or one that calls the functions of the metric.
RELEVOFILTERSREFINEMENT_EXPORT std::unique_ptr<MetricEvaluator> MakeEvaluator(
  vtkDepthTagMetric* metric, const std::shared_ptr<MetricMesh>& mesh);
}

#endif
