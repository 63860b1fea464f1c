// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthTagMetric
 * @brief   compute how deep to refine each point or edge of a mesh
 *
 * A metric computes depth-tags: float levels in [0, MaximumLevel], with the highest values where
 * refinement is needed most. An edge of level l, its tag rounded half up, is split into 2^l
 * segments. The level rule defines how edges get their tags:
 *
 * - PER_VERTEX: the metric computes a tag for each point. The tag of an edge is the mean of the
 *   tags of its two points (Lenz 2009, eqs. 3.1 to 3.3). Coincident points take the largest of
 *   their tags.
 * - PER_EDGE: the metric computes a tag for each edge, from data of that edge alone, so that the
 *   triangles on both sides agree (Lenz 2009, future work).
 *
 * Metrics use the points of the coarse mesh before displacement, except vtkCurvatureDepthTagMetric,
 * which measures the displaced surface.
 *
 * A metric stores parameters, but no data of a mesh. Mappers and filters create a
 * relevo::MetricEvaluator for each mesh. You can therefore share a metric between the blocks of a
 * mapper and between filters in several threads.
 *
 * To write a metric, override ComputeTags(). If it can cache results for a mesh, for example while
 * the camera moves, override NewEvaluator() instead. If you derive from a metric that has an
 * evaluator, which includes all metrics of Relevo, override NewEvaluator(): ComputeTags() is not
 * called if there is an evaluator.
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
   * How edges get their tags.
   */
  enum LevelRules
  {
    PER_VERTEX = 0,
    PER_EDGE = 1
  };

  /**
   * Return whether the tags depend on the camera. They are then recomputed when it moves.
   */
  virtual bool IsViewDependent() = 0;

  /**
   * Return whether the tags depend on the position of the mesh in the world. They are then
   * recomputed when its actor moves. By default this is true for metrics that depend on the view.
   */
  virtual bool IsPlacementDependent() { return this->IsViewDependent(); }

  /**
   * Return whether the tags depend on the recipe's surface and displacement. They are then
   * recomputed when these change. False by default.
   */
  virtual bool IsDisplacementDependent() { return false; }

  /**
   * Return whether levels are absolute: a level gives the number of segments that an edge needs,
   * and MaximumLevel only limits it. A recipe with a level offset then requests levels above
   * MaximumLevel, so that the offset is added before the limit applies. Otherwise, levels are
   * relative to MaximumLevel. False by default.
   */
  virtual bool IsAbsolute() { return false; }

  /**
   * Fill `tags` with one level per point of `mesh`, each finite and in [0, maximumLevel]. Returns
   * false after reporting an error if the metric cannot be evaluated, for example because a
   * view-dependent metric has no camera, an array is missing or parameters contradict each other.
   * The default implementation uses an evaluator.
   */
  virtual bool ComputeTags(
    vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags);

#ifndef __VTK_WRAP__
  /**
   * Fill `tags` with one level per edge of `mesh`, in the order of `edges`, each finite and in
   * [0, maximumLevel]. A tag must depend only on its edge. `edges` must be the edges of `mesh`.
   * Returns false after reporting an error. The default implementation uses an evaluator, or else
   * the mean of the tags of the edge's two merged points.
   */
  virtual bool ComputeEdgeTags(vtkPolyData* mesh, const relevo::RefinementView& view,
    int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags);

  /**
   * Set `shader` to compute the tags of `mesh` from its points relative to `origin`; see
   * relevo::MetricShader. Returns false after reporting an error. The default implementation uses
   * an evaluator. Without one, the shader is empty.
   */
  virtual bool GetShader(vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel,
    const double origin[3], relevo::MetricShader& shader);

  /**
   * Create an evaluator of this metric for a mesh, which can cache results. The default
   * implementation returns nullptr, so that the metric is called whenever tags are needed.
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
