// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthTagFilter
 * @brief   add the depth-tags and edge levels of a metric to a mesh
 *
 * The output is the input with two more arrays:
 *
 * - The point array "DepthTag" (float) has the level of each point in [0, MaximumLevel], computed
 *   by the metric. Coincident points get the largest of their tags.
 * - The cell array "EdgeLevels" (int, 3 components) has the levels of the edges P1P2, P2P3 and P3P1
 *   of each triangle (P1, P2, P3). A level is the tag of the edge, rounded half up and clamped to
 *   [0, MaximumLevel]; an edge of level l is split into 2^l segments. Depending on LevelRule, the
 *   tag is the mean of the tags of its points (Lenz 2009, eqs. 3.1 to 3.3) or the metric's tag for
 *   the edge. Cells that are not triangles have (-1, -1, -1).
 *
 * Without a metric, the filter uses the input's point array "DepthTag", with one number per point.
 * These tags may be out of [0, MaximumLevel]; only edge levels are clamped. LevelRule is ignored.
 *
 * The filter reports an error, and its output is empty, if there is neither a metric nor an array,
 * if the array has the wrong length or contains NaN, if a view-dependent metric has no camera, or
 * if a metric fails, returns the wrong number of tags or returns NaN. Relevo's metrics return level
 * 0 for non-finite points.
 *
 * If you refine the output with a vtkAdaptiveRefinement, "DepthTag" replaces the metric of the
 * recipe.
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
   * Set the metric that computes the tags. None, the default, means the input's array "DepthTag".
   */
  void SetMetric(vtkDepthTagMetric* metric);
  vtkDepthTagMetric* GetMetric();
  //@}

  //@{
  /**
   * Set the highest level of points and edges, 0 to 7. The default is 3. Values out of range are
   * rejected with an error.
   */
  void SetMaximumLevel(int level);
  vtkGetMacro(MaximumLevel, int);
  //@}

  //@{
  /**
   * Set the rule for the levels of edges. vtkDepthTagMetric::PER_VERTEX (0, the default) uses the
   * tags of their points. vtkDepthTagMetric::PER_EDGE (1) uses the metric's tags for edges. Edges
   * that only triangles with coincident or non-finite corners have get level 0. Other values are
   * rejected with an error.
   */
  void SetLevelRule(int rule);
  vtkGetMacro(LevelRule, int);
  void SetLevelRuleToPerVertex() { this->SetLevelRule(vtkDepthTagMetric::PER_VERTEX); }
  void SetLevelRuleToPerEdge() { this->SetLevelRule(vtkDepthTagMetric::PER_EDGE); }
  //@}

  //@{
  /**
   * Set the controller of the processes that have the other pieces of the surface. By default there
   * is none, and the input is the whole surface. See vtkAdaptiveRefinementFilter::SetController()
   * for the requirements. vtkPDepthTagFilter in the ParaView plugin sets the controller.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  //@}

  /**
   * Return the time of the latest change of the filter or its metric. If the metric depends on
   * Camera or ModelToWorld, their times count too.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkDepthTagFilter();
  ~vtkDepthTagFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Process one mesh. Returns false after reporting an error.
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
