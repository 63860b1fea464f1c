// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveTags
 * @brief   into how many segments a recipe cuts each curve
 *
 * From the array of depth-tags of the input's points, the mean of a curve's two ends; else from the
 * metric, the largest tag of a curve's control points, see CurveMesh::NewControlPolygons(). What
 * metrics know of the curves is kept from frame to frame.
 *
 * Private to the modules' own sources.
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

  /// Forget the curves, as when the mesh has been built anew.
  void Reset();

  /// `mesh` is the input's. False, with an error to show the user, when the array or the metric
  /// cannot be used.
  bool Compute(vtkAdaptiveRefinement* recipe, vtkPointSet* input, const CurveMesh& mesh,
    const RefinementView& view, std::string& error);

  /// By curve; in [0, MaximumLevel], the recipe's offset added.
  const std::vector<float>& GetTags() const { return this->Tags; }

  /// By curve.
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
