// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthTagMetric
 * @brief   how deep each point of a mesh is to be refined
 *
 * A metric gives depth-tags: float levels in [0, MaximumLevel], MaximumLevel where refinement is
 * wanted most. An edge of level l, its tag rounded half up, is split into 2^l segments. The user of
 * the metric chooses the rule by which edges get their tags:
 *
 * - PER_VERTEX: the metric gives every point a tag, and an edge has the mean of its two points'
 *   tags, the larger where points coincide (Lenz 2009, eqs. 3.1 to 3.3).
 * - PER_EDGE: the metric gives every edge a tag of its own, from what is known of that edge alone,
 *   so that the triangles beside it agree (Lenz 2009, future work).
 *
 * Metrics look at the points of the coarse mesh as they are, where displacement by a height map has
 * not moved them yet. vtkCurvatureDepthTagMetric looks at the displaced surface.
 *
 * A metric holds parameters and nothing about a mesh. Mappers and filters evaluate it by a
 * relevo::MetricEvaluator of their own for each mesh, so that metrics are shared freely, by the
 * blocks of a mapper and by filters in several threads alike.
 *
 * A metric of one's own overrides ComputeTags(); one that computes much of a mesh that it can use
 * again, as when the camera moves, overrides NewEvaluator() instead. So does a subclass of a metric
 * that has an evaluator, as all of Relevo's have: where there is one, ComputeTags() is not asked.
 *
 * @sa vtkAdaptiveRefinement vtkDepthTagFilter
 */
#ifndef vtkDepthTagMetric_h
#define vtkDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for NewEvaluator

class vtkFloatArray;
class vtkPolyData;

#ifndef __VTK_WRAP__
namespace relevo
{
struct RefinementView;
class MetricEvaluator;
class MetricMesh;
class SurfaceEdges;
struct MetricShader;
}
#endif

class RELEVOFILTERSREFINEMENT_EXPORT vtkDepthTagMetric : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkDepthTagMetric, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The rules by which edges get their tags.
   */
  enum LevelRules
  {
    PER_VERTEX = 0,
    PER_EDGE = 1
  };

  /**
   * Whether the tags depend on the camera, so that they must be computed anew when it moves.
   */
  virtual bool IsViewDependent() = 0;

  /**
   * Whether the tags depend on where the mesh lies in the world, so that they must be computed anew
   * when its actor moves. True for metrics that depend on the view.
   */
  virtual bool IsPlacementDependent() { return this->IsViewDependent(); }

  /**
   * Whether the tags depend on the surface and the displacement of the recipe, so that they must be
   * computed anew when these change. False unless overridden: metrics look at the coarse mesh.
   */
  virtual bool IsDisplacementDependent() { return false; }

  /**
   * Whether a level says how many segments an edge needs, so that MaximumLevel only limits levels;
   * otherwise levels are shares of MaximumLevel. Levels that are cut off are lost to a level
   * offset, which asks for more of them.
   */
  virtual bool IsAbsolute() { return false; }

  /**
   * Fill `tags` with one level per point of `mesh`, each finite and in [0, maximumLevel].
   * Returns false, after an ErrorEvent of this object, when the metric cannot be evaluated
   * (no camera for a view-dependent metric, a missing array, parameters that contradict each
   * other). Unless overridden, an evaluator is made and asked.
   */
  virtual bool ComputeTags(
    vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags);

#ifndef __VTK_WRAP__
  /**
   * Fill `tags` with one level per edge of `mesh`, in the order of `edges`, each finite and in
   * [0, maximumLevel], and depending on the edge alone. `edges` are those of `mesh` as it is.
   * Returns false as ComputeTags() does. Unless overridden, an evaluator is made and asked; without
   * one, an edge has the mean of the tags of its two places.
   */
  virtual bool ComputeEdgeTags(vtkPolyData* mesh, const relevo::RefinementView& view,
    int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags);

  /**
   * How a shader would compute the tags of `mesh` from its points relative to `origin`; see
   * relevo::MetricShader. Returns false as ComputeTags() does. Unless overridden, an evaluator is
   * made and asked; without one, there is no shader.
   */
  virtual bool GetShader(vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel,
    const double origin[3], relevo::MetricShader& shader);

  /**
   * What evaluates this metric for a mesh and keeps what it computes of it. Unless overridden none
   * (nullptr): the metric itself is asked whenever tags are needed.
   */
  virtual std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh);
#endif

protected:
  vtkDepthTagMetric();
  ~vtkDepthTagMetric() override;

private:
  vtkDepthTagMetric(const vtkDepthTagMetric&) = delete;
  void operator=(const vtkDepthTagMetric&) = delete;
};

#endif
