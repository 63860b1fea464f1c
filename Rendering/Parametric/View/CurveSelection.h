// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveSelection
 * @brief   which curves a view shows, grouped by their numbers of segments
 *
 * Evaluated anew when the curves, the recipe or what matters of the view have changed. Private to
 * the module.
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
  /// Curves of the same number of segments, and where they lie among the members.
  struct Group
  {
    int Segments;
    int Offset;
    int Count;
  };

  /// Take the curves of an input; both live on. SetReaches() follows.
  void SetCurves(vtkPointSet* input, const CurveMesh& curves);

  /**
   * How far what is drawn of the curves reaches to all sides: by control point or, if there is one
   * number only, everywhere. `origin` is what a CullingView is relative to.
   */
  void SetReaches(const std::vector<double>& reaches, const dvec3& origin);

  /**
   * Choose for a view; `culling` is nullptr where all curves are drawn. False with an error if the
   * recipe cannot be evaluated.
   */
  bool Update(vtkAdaptiveRefinement* recipe, const RefinementView& view, const CullingView* culling,
    std::string& error);

  const std::vector<Group>& GetGroups() const { return this->Groups; }
  /// Numbers of curves, group by group.
  const std::vector<unsigned int>& GetMembers() const { return this->Members; }
  /// When the groups were made.
  vtkMTimeType GetGroupsTime() const { return this->GroupsTime; }

  //@{
  /// Of the drawn curves, and of the hidden ones, if none has more than `most`.
  vtkIdType CountDrawnSegments(int most) const;
  vtkIdType CountHiddenSegments(int most) const;
  //@}
  vtkIdType GetNumberOfHiddenCurves() const
  {
    return static_cast<vtkIdType>(this->Tags.GetSegments().size() - this->Members.size());
  }
  /// How often levels have been evaluated.
  vtkIdType GetNumberOfEvaluations() const { return this->NumberOfEvaluations; }

private:
  bool UpdateSegments(
    vtkAdaptiveRefinement* recipe, const RefinementView& view, std::string& error);
  void UpdateHidden(const CullingView* view);
  void MakeGroups();

  vtkPointSet* Input = nullptr;
  const CurveMesh* Curves = nullptr;
  CurveTags Tags;
  std::vector<vec3> Boxes; // the middle and half the sides of each
  Dependencies TagDependencies;
  std::string Error; // of the tags
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
