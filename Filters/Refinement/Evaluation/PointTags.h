// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::PointTags
 * @brief   depth-tags per point from a recipe, for your own filters of cells other than triangles
 *
 * The recipe's array of depth-tags overrides its metric, as in vtkAdaptiveRefinementFilter. Results
 * of the metric for a mesh are cached until the mesh or the metric changes. Not thread-safe.
 */
#ifndef PointTags_h
#define PointTags_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkNew.h"                        // for members

#include <functional> // for GetMesh
#include <memory>     // for members
#include <string>     // for errors

class vtkAdaptiveRefinement;
class vtkDataSet;
class vtkFloatArray;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class MetricCache;

class RELEVOFILTERSREFINEMENT_EXPORT PointTags
{
public:
  PointTags();
  ~PointTags();
  PointTags(const PointTags&) = delete;
  void operator=(const PointTags&) = delete;

  enum Kinds
  {
    UNIFORM,  // MaximumLevel everywhere: the recipe has neither a metric nor an array
    OF_ARRAY, // GetValues() has one tag per point of the input
    OF_METRIC // GetValues() has one tag per point of the metric's mesh
  };

  /// Returns the mesh that the metric measures. Called only if it is needed.
  using GetMesh = std::function<vtkPolyData*()>;

  /**
   * Compute the tags, without the recipe's offset. Returns false and an error for the user if the
   * array or the metric cannot be used.
   */
  bool Compute(vtkAdaptiveRefinement* recipe, vtkDataSet* input, const GetMesh& getMesh,
    const RefinementView& view, std::string& error);

  Kinds GetKind() const { return this->Kind; }
  /// Return the tags, which are finite.
  const float* GetValues() const;

  /// Release the mesh and the cache.
  void Reset();

private:
  Kinds Kind = UNIFORM;
  vtkNew<vtkFloatArray> Values;
  std::unique_ptr<MetricCache> Source;
};
}

#endif
