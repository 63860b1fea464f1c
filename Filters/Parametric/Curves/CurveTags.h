// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveTags
 * @brief   levels and numbers of segments of curves, according to a recipe
 *
 * The level is the mean of the depth-tags at both ends, if the input has a depth-tag array.
 * Otherwise it is the largest tag that the metric gives the control points, see
 * CurveMesh::NewControlPolygons(). Data of metrics about the curves is cached between frames.
 *
 * Private to the modules.
 */
#ifndef CurveTags_h
#define CurveTags_h

#include "Evaluation/PointTags.h"          // for members
#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkSmartPointer.h"               // for members

#include <string> // for errors
#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkPointSet;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class CurveMesh;

class RELEVOFILTERSPARAMETRIC_EXPORT CurveTags
{
public:
  CurveTags();
  ~CurveTags();
  CurveTags(const CurveTags&) = delete;
  void operator=(const CurveTags&) = delete;

  /// Clears the cache. Call this when the mesh has been rebuilt.
  void Reset();

  /// `mesh` belongs to `input`. Returns false with an `error` if the array or the metric is
  /// invalid.
  bool Compute(vtkAdaptiveRefinement* recipe, vtkPointSet* input, const CurveMesh& mesh,
    const RefinementView& view, std::string& error);

  /// Returns a tag for each curve, in [0, MaximumLevel], with the recipe's offset added.
  const std::vector<float>& GetTags() const { return this->Tags; }

  /// Returns the number of segments of each curve.
  const std::vector<int>& GetSegments() const { return this->Segments; }

private:
  void TakeTags(const CurveMesh& mesh, float highest);
  void ChooseSegments(vtkAdaptiveRefinement* recipe);

  std::vector<float> Tags;
  std::vector<int> Segments;
  PointTags OfPoints;
  vtkSmartPointer<vtkPolyData> Polygons;
};
}

#endif
