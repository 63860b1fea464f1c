// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewSelection
 * @brief   the levels of a mesh for one view, and the faces to draw, kept until something changes
 *
 * Levels are evaluated anew when the mesh, the recipe or, for view-dependent metrics, the view
 * changed; faces are grouped anew when their levels or the faces in sight changed. CPU side only.
 * Private to the module.
 */
#ifndef vtkViewSelection_h
#define vtkViewSelection_h

#include "vtkEdgeTags.h"         // for members
#include "vtkFaceCulling.h"      // for LastView
#include "vtkPatternSelection.h" // for members
#include "vtkTimeStamp.h"        // for members

#include <memory> // for LastView
#include <string> // for errors
#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkPolyData;
struct vtkRefinementView;

namespace relevo
{
class RefinementMesh;

/// Values that decide whether something must be made anew.
using Dependencies = std::vector<vtkMTimeType>;

/// What a mapper draws.
struct SelectionInput
{
  vtkPolyData* Input;
  vtkAdaptiveRefinement* Recipe;
  const RefinementMesh* Mesh;
  vtkMTimeType MeshTime;
};

/// What is out of sight.
struct CullingInput
{
  /// nullptr where all faces are drawn.
  const FaceCulling* Culling;
  vtkMTimeType CullingTime;
  const CullingView* View;
  /// Whether back faces of closed surfaces are out of sight too.
  bool Behind;
};

class ViewSelection
{
public:
  /**
   * Evaluate levels if need be. False, with an error the first time, when depth-tags cannot be
   * used. `evaluated` tells whether they were evaluated. With `onGPU` only tags are: the GPU does
   * the rest.
   */
  bool UpdateLevels(const SelectionInput& input, const vtkRefinementView& view, bool onGPU,
    bool& evaluated, std::string& error);

  /**
   * Group the faces if need be, for valid levels.
   */
  void UpdateGroups(const CullingInput& culling);

  /// Evaluate levels anew, with the next update.
  void ForgetLevels() { this->LevelDependencies.clear(); }

  const EdgeTags& GetTags() const { return this->Tags; }
  const PatternSelection& GetSelection() const { return this->Selection; }

  /// Take over what the GPU has chosen for each face; see PatternSelection::Assign().
  void Assign(
    const SelectionInput& input, std::vector<unsigned int> entries, std::vector<float> morphTags);

  /// When the levels and the groups last changed.
  vtkMTimeType GetLevelsTime() const { return this->LevelsTime; }
  vtkMTimeType GetGroupsTime() const { return this->GroupsTime; }

  /// Seconds the last evaluation and the last grouping took.
  double GetSeconds() const { return this->LevelsSeconds + this->GroupsSeconds; }

  /// Faces that were left out.
  int GetNumberOfHiddenFaces() const { return this->NumberOfHiddenFaces; }

  /// Triangles of all faces, less those over no-data.
  vtkIdType GetNumberOfTriangles(const SelectionInput& input);

private:
  bool SeesTheSame(const CullingInput& culling) const;

  EdgeTags Tags;
  vtkMTimeType TagsMeshTime = 0;
  PatternSelection Selection;
  Dependencies LevelDependencies;
  bool Valid = false;
  vtkTimeStamp LevelsTime;
  vtkTimeStamp GroupsTime;
  std::vector<unsigned char> Hidden;
  std::vector<unsigned char> LastHidden;
  std::unique_ptr<CullingView> LastView; // that the faces were grouped for, if faces were culled
  vtkMTimeType LastCullingTime = 0;
  bool LastBehind = false;
  int NumberOfHiddenFaces = 0;
  double LevelsSeconds = 0.0;
  double GroupsSeconds = 0.0;
  vtkIdType NumberOfTriangles = -1; // not counted yet
};

//@{
/// Add what decides.
void Append(Dependencies& dependencies, const void* object, vtkMTimeType time);
template <typename T>
void AppendObject(Dependencies& dependencies, T* object)
{
  Append(dependencies, object, object ? object->GetMTime() : 0);
}
//@}
}

#endif
