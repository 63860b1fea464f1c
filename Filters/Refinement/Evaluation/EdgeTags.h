// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EdgeTags
 * @brief   the tags that decide how deep each edge of a mesh is refined
 *
 * The stage "tag" of a frame: from the input's own array or the recipe's metric, one tag per point
 * (an edge takes the mean of its two; points at one place count as one) or one per edge. Either
 * way the tag of an edge is the same in all its faces. Memory is kept from frame to frame. What is
 * known of the mesh itself is in a MetricCache, which the tags for several views may share.
 */
#ifndef EdgeTags_h
#define EdgeTags_h

#include "Metrics/MetricShader.h"          // for Shader
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkNew.h"                        // for Values
#include "vtkType.h"                       // for vtkIdType

#include <memory> // for std::unique_ptr
#include <string> // for errors
#include <vector> // for members

class vtkAbstractArray;
class vtkAdaptiveRefinement;
class vtkDataSet;
class vtkDepthTagMetric;
class vtkFloatArray;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class RefinementMesh;
class SurfaceEdges;
class MetricCache;

class RELEVOFILTERSREFINEMENT_EXPORT EdgeTags
{
public:
  /// With a source of its own, or a shared one.
  EdgeTags();
  explicit EdgeTags(std::shared_ptr<MetricCache> source);
  ~EdgeTags();
  EdgeTags(const EdgeTags&) = delete;
  void operator=(const EdgeTags&) = delete;

  enum Kinds
  {
    UNIFORM,   // MaximumLevel everywhere: the recipe has neither metric nor array
    PER_POINT, // Values by point id
    PER_EDGE   // Values by GetFaceEdges()
  };

  /**
   * Evaluate. `mesh` is the input's; call Reset() when it has been built anew. Tags of metrics go
   * up to `highest`, see GetHighestTag(). Returns false and fills `error` when the array or the
   * metric cannot be used.
   */
  bool Compute(vtkAdaptiveRefinement* recipe, vtkPolyData* input, const RefinementMesh& mesh,
    const RefinementView& view, int highest, std::string& error);
  /// The same where no budget moves levels.
  bool Compute(vtkAdaptiveRefinement* recipe, vtkPolyData* input, const RefinementMesh& mesh,
    const RefinementView& view, std::string& error);

  /**
   * The same for a GPU: a metric that shaders can evaluate is only described by GetShader(), and
   * there are no values.
   */
  bool ComputeOrDescribe(vtkAdaptiveRefinement* recipe, vtkPolyData* input,
    const RefinementMesh& mesh, const RefinementView& view, std::string& error);

  /// The metric to evaluate, by the rule of GetKind(); nullptr where there are values.
  const MetricShader* GetShader() const
  {
    return this->Shader.Source.empty() ? nullptr : &this->Shader;
  }

  /// The edges of the mesh; per edge, and for metrics that only edges have tags of.
  const SurfaceEdges* GetEdges() const { return this->Edges.get(); }

  /// Forget the faces.
  void Reset();

  //@{
  /// What the tags are computed from.
  void SetSource(std::shared_ptr<MetricCache> source);
  const std::shared_ptr<MetricCache>& GetSource() const { return this->Source; }
  //@}

  Kinds GetKind() const { return this->Kind; }

  /// Finite values.
  const float* GetValues() const;
  vtkIdType GetNumberOfValues() const;

  /// For each face the indices of its edges (0,1), (1,2), (0,2); per edge only.
  const std::vector<int>& GetFaceEdges() const { return this->FaceEdges; }

private:
  void BuildEdges(vtkPolyData* input, const RefinementMesh& mesh);

  Kinds Kind = UNIFORM;
  vtkNew<vtkFloatArray> Values;
  std::shared_ptr<MetricCache> Source;
  std::shared_ptr<const SurfaceEdges> Edges;
  std::vector<int> FaceEdges;
  MetricShader Shader;
};
}

#endif
