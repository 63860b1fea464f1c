// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthTagFilter
 * @brief   writes how deep a metric would refine a mesh
 *
 * The output is the input, everything passed through, with two more arrays:
 *
 * - point array "DepthTag" (float): the level of every point, in [0, MaximumLevel], by the metric.
 *   Points at the same coordinates get the largest of their tags.
 * - cell array "EdgeLevels" (int, 3 components): for a triangle (P1, P2, P3) the levels of its
 *   edges P1P2, P2P3, P3P1: their tags rounded half up and clamped to [0, MaximumLevel]. Such an
 *   edge is split into 2^level segments. Its tag is by LevelRule the mean of its points' tags
 *   (Lenz 2009, eqs. 3.1 to 3.3) or the metric's tag for the edge itself. Cells that are not
 *   triangles have (-1, -1, -1).
 *
 * Without a metric the tags are the input's own point array "DepthTag", one number per point, which
 * may exceed [0, MaximumLevel]: only the levels of edges are clamped. LevelRule is not used then.
 *
 * Errors, with an empty output: neither metric nor array; an array of another length or with a
 * NaN; a metric that depends on the view without a camera; a metric that fails, or gives another
 * number of tags than there are points or edges, or a NaN. Relevo's own metrics give level 0 to a
 * point with a coordinate that is not finite.
 *
 * A vtkAdaptiveRefinement that is given the output uses "DepthTag" in place of its own metric.
 *
 * @sa vtkDepthTagMetric vtkAdaptiveRefinement
 */
#ifndef vtkDepthTagFilter_h
#define vtkDepthTagFilter_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"             // for LevelRules
#include "vtkSmartPointer.h"               // for members
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for members

class vtkFloatArray;
class vtkIntArray;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
class TagSources;
}

class RELEVOFILTERSREFINEMENT_EXPORT vtkDepthTagFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkDepthTagFilter* New();
  vtkTypeMacro(vtkDepthTagFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The metric that gives the tags. None (the default): the input's array "DepthTag".
   */
  void SetMetric(vtkDepthTagMetric* metric);
  vtkDepthTagMetric* GetMetric();
  //@}

  //@{
  /**
   * The highest level of a point and of an edge, 0 to 7, default 3. A value outside is an error
   * and changes nothing.
   */
  void SetMaximumLevel(int level);
  vtkGetMacro(MaximumLevel, int);
  //@}

  //@{
  /**
   * Where the levels of edges come from: vtkDepthTagMetric::PER_VERTEX (0, the default), the tags
   * of their points, or PER_EDGE (1), tags that the metric gives to edges; 0 for an edge that only
   * triangles with two corners at one place, or with a corner that is not finite, have. Another
   * value is an error and changes nothing.
   */
  void SetLevelRule(int rule);
  vtkGetMacro(LevelRule, int);
  void SetLevelRuleToPerVertex() { this->SetLevelRule(vtkDepthTagMetric::PER_VERTEX); }
  void SetLevelRuleToPerEdge() { this->SetLevelRule(vtkDepthTagMetric::PER_EDGE); }
  //@}

  //@{
  /**
   * The processes that have the other pieces of the surface; none, the default, means that the
   * input is all of it. See vtkAdaptiveRefinementFilter::SetController() for what pieces must have,
   * and vtkPDepthTagFilter of the plugin for ParaView, which sets it.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  //@}

  /**
   * Latest change of the filter, its metric or, where the metric depends on them, Camera and
   * ModelToWorld.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkDepthTagFilter();
  ~vtkDepthTagFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// RequestData() for one mesh: false after an ErrorEvent.
  bool AddTags(vtkPolyData* input, vtkPolyData* output);

  vtkSmartPointer<vtkDepthTagMetric> Metric;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  int MaximumLevel = 3;
  int LevelRule = vtkDepthTagMetric::PER_VERTEX;

private:
  vtkDepthTagFilter(const vtkDepthTagFilter&) = delete;
  void operator=(const vtkDepthTagFilter&) = delete;

  bool AskMetric(vtkPolyData* input, bool perEdge, vtkFloatArray* tags);
  bool ComputeTags(vtkPolyData* input, vtkFloatArray* tags);
  bool TakeTags(vtkPolyData* input, vtkFloatArray* tags);
  bool ComputeEdgeLevels(vtkPolyData* input, const float* tags, vtkIntArray* edgeLevels);

  std::unique_ptr<relevo::TagSources> Sources;
};

#endif
