// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternSelection
 * @brief   from tags of edges to groups of faces that share a pattern
 *
 * The stages select and group of a frame (Lenz 2009, sections 4.4 and 4.5): the steps of a face's
 * edges choose its pattern, and the faces to be drawn are sorted by pattern.
 */
#ifndef PatternSelection_h
#define PatternSelection_h

#include "Patterns/FacePattern.h"          // for GetFacePattern
#include "Patterns/PatternFamily.h"        // for Family
#include "Patterns/RefinementPattern.h"    // for RefinementPatterns
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <memory> // for families
#include <string> // for sentences
#include <vector> // for members

namespace relevo
{
class EdgeTags;
class RefinementMesh;

/**
 * Faces drawn with one pattern and one winding: a range of Instances.
 */
struct PatternGroup
{
  std::shared_ptr<const RefinementPattern> Pattern;
  /// Whether the pattern's triangles are turned over.
  bool Mirrored;
  int Offset;
  int Count;
};

class RELEVOFILTERSREFINEMENT_EXPORT PatternSelection
{
public:
  /**
   * Choose a pattern for every face, with edges of levels up to the maximum. `offset` is added to
   * the tags of all edges.
   */
  void Select(const RefinementMesh& mesh, const EdgeTags& tags, const PatternFamily& family,
    int maximumLevel, float offset = 0.0f);

  /**
   * Take what was chosen elsewhere: the family's entry of each face and, if its patterns morph, the
   * tags that vertices morph by.
   */
  void Assign(
    const PatternFamily& family, std::vector<unsigned int> entries, std::vector<float> morphTags);

  /**
   * Sort the faces by pattern, those of them that are not hidden: `hidden` has a byte per face, or
   * is nullptr for none.
   */
  void Group(const unsigned char* hidden = nullptr);

  /// The grouped faces: face << 3 | permutation code (relevoWeights.glsl), sorted by group; by
  /// face within a group.
  std::vector<unsigned int> Instances;
  std::vector<PatternGroup> Groups;

  /// Number of faces selected.
  int GetNumberOfFaces() const { return static_cast<int>(this->Entries.size()); }

  /// The pattern of a face.
  FacePattern GetFacePattern(int face) const
  {
    const unsigned int entry = this->Entries[face];
    return { this->Patterns[entry >> 3].get(), static_cast<int>(entry & 7u),
      PatternFamily::IsMirrored(static_cast<int>(entry >> 3)),
      this->MorphTags.empty() ? nullptr : &this->MorphTags[3 * static_cast<std::size_t>(face)] };
  }

  /// Per face the tags of its edges (0,1), (1,2), (0,2) that its vertices morph by; empty where
  /// they do not.
  const std::vector<float>& GetMorphTags() const { return this->MorphTags; }

  /// Triangles of all faces, and of those grouped.
  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  vtkIdType GetNumberOfGroupedTriangles() const;

private:
  template <typename GetTags, typename GetStep>
  void SelectFaces(const RefinementMesh& mesh, const PatternFamily& family, float offset,
    int maximumLevel, const GetTags& getTags, const GetStep& getStep);
  void ResizeCounts(const PatternFamily& family);
  void CountFaces(const unsigned char* hidden);
  /// Take the patterns in use.
  void FindPatterns(const PatternFamily& family);

  std::vector<unsigned int> Entries; // per face, of the family
  std::vector<float> MorphTags;
  RefinementPatterns Patterns;          // by key; nullptr where not in use
  std::vector<std::vector<int>> Counts; // of faces per key, by chunk of faces
  bool Counted = false;                 // all faces
  vtkIdType NumberOfTriangles = 0;
};
}

#endif
