// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EdgeTags
 * @brief   the tags that determine the level of each edge of a mesh
 *
 * This is the tag stage of a frame. It computes tags from the input's array or the recipe's metric:
 * one per point, where an edge takes the mean of its two merged points, or one per edge. The tag of
 * an edge is therefore the same in all its faces. Memory is reused from frame to frame. Data of the
 * mesh are in a MetricCache, which tags for several views can share.
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
  /// Create tags with a separate or a shared cache.
  EdgeTags();
  explicit EdgeTags(std::shared_ptr<MetricCache> source);
  ~EdgeTags();
  EdgeTags(const EdgeTags&) = delete;
  void operator=(const EdgeTags&) = delete;

  enum Kinds
  {
    UNIFORM,   // MaximumLevel everywhere: the recipe has neither metric nor array
    PER_POINT, // values by point id
    PER_EDGE   // values by GetFaceEdges()
  };

  /**
   * Compute the tags. `mesh` is built from the input; call Reset() after it is rebuilt. Tags of
   * metrics are at most `highest`, see GetHighestTag(). Returns false and sets `error` if the array
   * or the metric cannot be used.
   */
  bool Compute(vtkAdaptiveRefinement* recipe, vtkPolyData* input, const RefinementMesh& mesh,
    const RefinementView& view, int highest, std::string& error);
  /// Does the same without a triangle budget.
  bool Compute(vtkAdaptiveRefinement* recipe, vtkPolyData* input, const RefinementMesh& mesh,
    const RefinementView& view, std::string& error);

  /**
   * Does the same for a GPU: if shaders can evaluate the metric, only GetShader() is set, and there
   * are no values.
   */
  bool ComputeOrDescribe(vtkAdaptiveRefinement* recipe, vtkPolyData* input,
    const RefinementMesh& mesh, const RefinementView& view, std::string& error);

  /// The metric to evaluate, with the rule of GetKind(); nullptr if there are values.
  const MetricShader* GetShader() const
  {
    return this->Shader.Source.empty() ? nullptr : &this->Shader;
  }

  /// The edges of the mesh, for PER_EDGE and for metrics that tag only edges.
  const SurfaceEdges* GetEdges() const { return this->Edges.get(); }

  /// Clear the data of the faces.
  void Reset();

  //@{
  /// The cache that the tags are computed from.
  void SetSource(std::shared_ptr<MetricCache> source);
  const std::shared_ptr<MetricCache>& GetSource() const { return this->Source; }
  //@}

  Kinds GetKind() const { return this->Kind; }

  /// The tags, which are finite.
  const float* GetValues() const;
  vtkIdType GetNumberOfValues() const;

  /// The indices of the edges (0,1), (1,2), (0,2) of each face; only for PER_EDGE.
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
