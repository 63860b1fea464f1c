// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewSelection
 * @brief   the cached levels of a mesh for one view, and the faces to draw
 *
 * Tags are evaluated again when the mesh, the recipe or, for view-dependent metrics, the view has
 * changed. Levels are evaluated again when the tags or their offset have changed. Faces are grouped
 * again when their levels or the visible faces have changed. It runs on the CPU. Private to the
 * module.
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

/// The input of a mapper.
struct SelectionInput
{
  vtkPolyData* Input;
  vtkAdaptiveRefinement* Recipe;
  std::shared_ptr<const RefinementMesh> Mesh;
  vtkMTimeType MeshTime;
  /// When the information on the whole surface has changed, if the mesh is a piece.
  vtkMTimeType WholeTime;
  /// See GetHighestTag().
  int HighestTag;
};

/// The input for culling.
struct CullingInput
{
  /// nullptr if all faces are drawn.
  const FaceCulling* Culling;
  vtkMTimeType CullingTime;
  const CullingView* View;
  /// Whether back faces of closed surfaces are culled, too.
  bool HidesBackFaces;
};

/// The sums over the drawn faces and over the culled faces.
struct FaceSums
{
  vtkIdType Drawn = 0;
  vtkIdType Culled = 0;
};

class ViewSelection
{
public:
  /// Share the cached evaluator of the metric with other views.
  void SetMetricCache(std::shared_ptr<MetricCache> cache)
  {
    this->Tags.SetSource(std::move(cache));
  }

  /**
   * Evaluate the tags if they are out of date, or leave it to the GPU if `onGPU` is true, see
   * EdgeTags::ComputeOrDescribe(). If they cannot be used, return false and set an error the first
   * time.
   */
  bool UpdateTags(
    const SelectionInput& input, const RefinementView& view, bool onGPU, std::string& error);

  const EdgeTags& GetTags() const { return this->Tags; }
  /// Return when the tags last changed.
  vtkMTimeType GetTagsTime() const { return this->TagsTime; }

  /**
   * Select levels for valid tags, if they are out of date. `offset` is added to the recipe's
   * offset. Return whether they are new. With `onGPU`, the GPU selects.
   */
  bool UpdateLevels(const SelectionInput& input, double offset, bool onGPU);

  /**
   * Find the culled faces, if they are out of date.
   */
  void UpdateSight(const CullingInput& culling);
  /// Return one byte per face, not 0 for culled faces; nullptr if all faces are drawn.
  const unsigned char* GetHidden() const
  {
    return this->NumberOfHiddenFaces > 0 ? this->Hidden.data() : nullptr;
  }
  /// Return when the culled faces last changed.
  vtkMTimeType GetSightTime() const { return this->SightTime; }

  /**
   * Group the drawn faces for valid levels, if the groups are out of date.
   */
  void UpdateGroups(const CullingInput& culling);

  /// Set the holes of the displacement, valid since a time; they reduce the number of triangles.
  void SetHoles(const HeightValidity& holes, vtkMTimeType time);

  /// Make all results out of date.
  void Forget()
  {
    this->TagDependencies.Clear();
    this->LevelDependencies.Clear();
  }

  const PatternSelection& GetSelection() const { return this->Selection; }

  /// Store the patterns that the GPU has selected for each face, see PatternSelection::Assign(),
  /// and the faces that it has culled.
  void Assign(const PatternFamily& family, std::vector<unsigned int> entries,
    std::vector<float> morphTags, std::vector<unsigned char> hidden);

  /// Return the mesh that the levels belong to, even if its input has changed since.
  const RefinementMesh& GetMesh() const;

  /// Return when the levels and the groups last changed.
  vtkMTimeType GetLevelsTime() const { return this->LevelsTime; }
  vtkMTimeType GetGroupsTime() const { return this->GroupsTime; }

  /// Return the seconds of the last evaluation and grouping.
  double GetSeconds() const
  {
    return this->TagsSeconds + this->LevelsSeconds + this->SightSeconds + this->GroupsSeconds;
  }

  /// Return the number of culled faces.
  int GetNumberOfHiddenFaces() const { return this->NumberOfHiddenFaces; }

  /// Return the sums of getNumber(face).
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

  /// Return the number of triangles, without those over no data.
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
  bool Valid = false; // whether the tags are valid
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
