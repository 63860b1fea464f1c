// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveSelection
 * @brief   the curves that a view shows, grouped by their number of segments
 *
 * It is evaluated again only when the curves, the recipe or, if it matters, the view have changed.
 * Private to the module.
 */
#ifndef CurveSelection_h
#define CurveSelection_h

#include "Changes/Dependencies.h"
#include "Curves/CurveTags.h"
#include "Mathematics/RefinementMathematics.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkAdaptiveRefinement;
class vtkPointSet;

namespace relevo
{
struct CullingView;
struct RefinementView;
class CurveMesh;

class CurveSelection
{
public:
  /// Curves with the same number of segments, and their range in the members.
  struct Group
  {
    int Segments;
    int Offset;
    int Count;
  };

  /// Set the curves of an input; both must outlive this object. Call SetReaches() next.
  void SetCurves(vtkPointSet* input, const CurveMesh& curves);

  /**
   * Set how far the drawn curves extend in all directions: per control point, or one number for
   * all. `origin` is the origin of the CullingView.
   */
  void SetReaches(const std::vector<double>& reaches, const dvec3& origin);

  /**
   * Select curves for a view. If `culling` is nullptr, all curves are drawn. Return false and set
   * an error if the recipe cannot be evaluated.
   */
  bool Update(vtkAdaptiveRefinement* recipe, const RefinementView& view, const CullingView* culling,
    std::string& error);

  const std::vector<Group>& GetGroups() const { return this->Groups; }
  /// Return the indices of curves, group by group.
  const std::vector<unsigned int>& GetMembers() const { return this->Members; }
  /// Return when the groups were made.
  vtkMTimeType GetGroupsTime() const { return this->GroupsTime; }

  //@{
  /// Return the number of segments of the drawn and of the hidden curves, with at most `most` per
  /// curve.
  vtkIdType CountDrawnSegments(int most) const;
  vtkIdType CountHiddenSegments(int most) const;
  //@}
  vtkIdType GetNumberOfHiddenCurves() const
  {
    return static_cast<vtkIdType>(this->Tags.GetSegments().size() - this->Members.size());
  }
  /// Return how often levels have been evaluated.
  vtkIdType GetNumberOfEvaluations() const { return this->NumberOfEvaluations; }

private:
  bool UpdateSegments(
    vtkAdaptiveRefinement* recipe, const RefinementView& view, std::string& error);
  void UpdateHidden(const CullingView* view);
  void MakeGroups();

  vtkPointSet* Input = nullptr;
  const CurveMesh* Curves = nullptr;
  CurveTags Tags;
  std::vector<vec3> Boxes; // the centre and half the extent of each curve
  Dependencies TagDependencies;
  std::string Error; // error of the tags
  vtkTimeStamp CurvesTime;
  vtkTimeStamp BoxesTime;
  vtkTimeStamp SegmentsTime;
  Dependencies SightDependencies;
  std::vector<unsigned char> Hidden;
  Dependencies GroupDependencies;
  std::vector<Group> Groups;
  std::vector<unsigned int> Members;
  vtkTimeStamp GroupsTime;
  vtkIdType NumberOfEvaluations = 0;
};
}

#endif
