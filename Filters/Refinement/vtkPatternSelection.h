// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatternSelection
 * @brief   from depth-tags to groups of faces that share a base pattern
 *
 * The stages tag, select and group of a frame (Lenz 2009, sections 4.4 and 4.5): depth-tags per
 * point, a level per edge, a base pattern and a permutation per face, and the faces sorted by base
 * pattern.
 *
 * Not wrapped: for the modules' own sources.
 */
#ifndef vtkPatternSelection_h
#define vtkPatternSelection_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <string> // for errors
#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkDepthTagMetric;
class vtkPolyData;
class vtkRefinementPatternTable;
struct vtkRefinementPattern;
struct vtkRefinementView;

#ifndef __VTK_WRAP__
namespace relevo
{
class RefinementMesh;

/**
 * One depth-tag per point, places united, from the recipe's array where the input has it, else from
 * its metric; empty when the recipe has neither, for MaximumLevel everywhere. Returns false and
 * fills `error` when the array or the metric cannot be used.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool ComputeDepthTags(vtkAdaptiveRefinement* recipe,
  vtkPolyData* input, const RefinementMesh& mesh, const vtkRefinementView& view,
  std::vector<float>& tags, std::string& error);

/**
 * The metric that ComputeDepthTags() asks; nullptr where it takes an array or nothing.
 */
RELEVOFILTERSREFINEMENT_EXPORT vtkDepthTagMetric* GetMetricInUse(
  vtkAdaptiveRefinement* recipe, vtkPolyData* input);

/**
 * Faces drawn with one base pattern and one winding: a range of Instances.
 */
struct PatternGroup
{
  /// Levels of the base pattern, descending.
  int Levels[3];
  /// Whether the permutations of the group mirror the pattern.
  bool Mirrored;
  int Offset;
  int Count;
};

class RELEVOFILTERSREFINEMENT_EXPORT PatternSelection
{
public:
  /**
   * Select and group. `tags` as from ComputeDepthTags().
   */
  void Select(const RefinementMesh& mesh, const std::vector<float>& tags, int maximumLevel);

  /// face << 3 | permutation code (relevoWeights.glsl), sorted by group; by face within a group.
  std::vector<unsigned int> Instances;
  std::vector<PatternGroup> Groups;

  vtkIdType GetNumberOfTriangles(vtkRefinementPatternTable* table) const;

private:
  std::vector<unsigned short> Keys;
};

/**
 * The pattern of a group.
 */
RELEVOFILTERSREFINEMENT_EXPORT const vtkRefinementPattern& GetGroupPattern(
  vtkRefinementPatternTable* table, const PatternGroup& group);
}
#endif

#endif
