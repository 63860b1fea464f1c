// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::PointTags
 * @brief   depth-tags per point by a recipe, for filters of your own that refine something else
 *          than triangles
 *
 * The recipe's array of depth-tags comes before its metric, as in vtkAdaptiveRefinementFilter. What
 * the metric computes of a mesh is kept until the mesh or the metric changes. An object is used by
 * one thread at a time.
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
    UNIFORM,  // the recipe has neither: MaximumLevel everywhere
    OF_ARRAY, // GetValues() by point of the input
    OF_METRIC // GetValues() by point of the metric's mesh
  };

  /// Makes the mesh that the metric measures. Only called when it is needed.
  using GetMesh = std::function<vtkPolyData*()>;

  /**
   * Compute the tags. The recipe's offset is not added. False, with an error to show the user, when
   * the array or the metric cannot be used.
   */
  bool Compute(vtkAdaptiveRefinement* recipe, vtkDataSet* input, const GetMesh& getMesh,
    const RefinementView& view, std::string& error);

  Kinds GetKind() const { return this->Kind; }
  /// Finite values.
  const float* GetValues() const;

  /// Forget the mesh.
  void Reset();

private:
  Kinds Kind = UNIFORM;
  vtkNew<vtkFloatArray> Values;
  std::unique_ptr<MetricCache> Source;
};
}

#endif
