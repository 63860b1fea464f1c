// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewSelection
 * @brief   the levels of a mesh for one view, and the faces to draw, kept until something changes
 *
 * Tags are evaluated anew when the mesh, the recipe or, for view-dependent metrics, the view
 * changed, and levels when the tags or what is added to them changed; faces are grouped anew when
 * their levels or the faces in view changed. CPU side only.
 * Private to the module.
 */
#ifndef ViewSelection_h
#define ViewSelection_h

#include "Changes/Dependencies.h"            // for members
#include "Evaluation/EdgeTags.h"             // for members
#include "Evaluation/FaceCulling.h"          // for CullingInput
#include "Evaluation/HoleFinder.h"           // for members
#include "Evaluation/PatternSelection.h"     // for members
#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkTimeStamp.h"                    // for members

#include <memory>  // for members
#include <string>  // for errors
#include <utility> // for std::move
#include <vector>  // for members

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class RefinementMesh;
class MetricCache;

/// What a mapper draws.
struct SelectionInput
{
  vtkPolyData* Input;
  vtkAdaptiveRefinement* Recipe;
  std::shared_ptr<const RefinementMesh> Mesh;
  vtkMTimeType MeshTime;
  /// When what is known of the whole changed that the mesh is a piece of.
  vtkMTimeType WholeTime;
  /// See GetHighestTag().
  int HighestTag;
};

/// Which faces are culled.
struct CullingInput
{
  /// nullptr where all faces are drawn.
  const FaceCulling* Culling;
  vtkMTimeType CullingTime;
  const CullingView* View;
  /// Whether back faces of closed surfaces are culled too.
  bool HidesBackFaces;
};

/// A sum over the faces that are drawn, and one over those that are culled.
struct FaceSums
{
  vtkIdType Drawn = 0;
  vtkIdType Culled = 0;
};

class ViewSelection
{
public:
  /// Compute tags from what other views share.
  void SetMetricCache(std::shared_ptr<MetricCache> cache)
  {
    this->Tags.SetSource(std::move(cache));
  }

  /**
   * Evaluate tags if need be, or leave it to the GPU `onGPU`, see EdgeTags::ComputeOrDescribe().
   * False, with an error the first time, when they cannot be used.
   */
  bool UpdateTags(
    const SelectionInput& input, const RefinementView& view, bool onGPU, std::string& error);

  const EdgeTags& GetTags() const { return this->Tags; }
  /// When the tags last changed.
  vtkMTimeType GetTagsTime() const { return this->TagsTime; }

  /**
   * Choose levels if need be, for valid tags. `offset` is added to the recipe's own. Returns
   * whether they are new. With `onGPU` the GPU does the choosing.
   */
  bool UpdateLevels(const SelectionInput& input, double offset, bool onGPU);

  /**
   * Find the faces that are culled if need be.
   */
  void UpdateSight(const CullingInput& culling);
  /// A byte per face, not 0 for those that are culled; nullptr where all are drawn.
  const unsigned char* GetHidden() const
  {
    return this->NumberOfHiddenFaces > 0 ? this->Hidden.data() : nullptr;
  }
  /// When the culled faces last changed.
  vtkMTimeType GetSightTime() const { return this->SightTime; }

  /**
   * Group the faces that are drawn if need be, for valid levels.
   */
  void UpdateGroups(const CullingInput& culling);

  /// Know what displacement leaves out of the triangles, since a time.
  void SetHoles(const HeightValidity& holes, vtkMTimeType time);

  /// Evaluate all anew, with the next update.
  void Forget()
  {
    this->TagDependencies.Clear();
    this->LevelDependencies.Clear();
  }

  const PatternSelection& GetSelection() const { return this->Selection; }

  /// Take over what the GPU has chosen for each face, see PatternSelection::Assign(), and which
  /// faces it has culled.
  void Assign(const PatternFamily& family, std::vector<unsigned int> entries,
    std::vector<float> morphTags, std::vector<unsigned char> hidden);

  /// The mesh that levels were chosen for, even if its input has changed since.
  const RefinementMesh& GetMesh() const;

  /// When the levels and the groups last changed.
  vtkMTimeType GetLevelsTime() const { return this->LevelsTime; }
  vtkMTimeType GetGroupsTime() const { return this->GroupsTime; }

  /// Seconds the last evaluation and the last grouping took.
  double GetSeconds() const
  {
    return this->TagsSeconds + this->LevelsSeconds + this->SightSeconds + this->GroupsSeconds;
  }

  /// Faces that were culled.
  int GetNumberOfHiddenFaces() const { return this->NumberOfHiddenFaces; }

  /// The sums of getNumber(face).
  template <typename GetNumber>
  FaceSums SumOverFaces(const GetNumber& getNumber) const
  {
    FaceSums sums;
    const unsigned char* hidden = this->GetHidden();
    for (int face = 0; face < this->Selection.GetNumberOfFaces(); ++face)
    {
      (hidden && hidden[face] ? sums.Culled : sums.Drawn) += getNumber(face);
    }
    return sums;
  }

  /// Triangles of the faces, less those over no-data.
  FaceSums CountTriangles();

private:
  EdgeTags Tags;
  vtkMTimeType TagsMeshTime = 0;
  std::shared_ptr<const RefinementMesh> Mesh;
  PatternSelection Selection;
  HeightValidity Holes;
  vtkMTimeType HolesTime = 0;
  Dependencies TagDependencies;
  Dependencies LevelDependencies;
  Dependencies GroupDependencies;
  Dependencies SightDependencies;
  bool Valid = false; // tags
  vtkTimeStamp TagsTime;
  vtkTimeStamp SightTime;
  vtkTimeStamp LevelsTime;
  vtkTimeStamp GroupsTime;
  std::vector<unsigned char> Hidden;
  std::vector<unsigned char> LastHidden;
  int NumberOfHiddenFaces = 0;
  double TagsSeconds = 0.0;
  double LevelsSeconds = 0.0;
  double SightSeconds = 0.0;
  double GroupsSeconds = 0.0;
  FaceSums NumbersOfTriangles;
  bool AreTrianglesCounted = false;
};
}

#endif
