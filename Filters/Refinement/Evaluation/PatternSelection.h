// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternSelection
 * @brief   groups faces by pattern, from the tags of their edges
 *
 * These are the select and group stages of a frame (Lenz 2009, sections 4.4 and 4.5). The steps of
 * a face's edges determine its pattern, and the faces to draw are sorted by pattern.
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
  /// Whether the pattern's triangles are reversed.
  bool Mirrored;
  int Offset;
  int Count;
};

class RELEVOFILTERSREFINEMENT_EXPORT PatternSelection
{
public:
  /**
   * Select a pattern for each face, with levels of edges up to the maximum. `offset` is added to
   * the tags of all edges.
   */
  void Select(const RefinementMesh& mesh, const EdgeTags& tags, const PatternFamily& family,
    int maximumLevel, float offset = 0.0f);

  /**
   * Set a selection that was computed elsewhere: the family's entry of each face and, if its
   * patterns morph, the tags for morphing.
   */
  void Assign(
    const PatternFamily& family, std::vector<unsigned int> entries, std::vector<float> morphTags);

  /**
   * Sort the faces that are not hidden by pattern. `hidden` has one byte per face, or is nullptr if
   * no face is hidden.
   */
  void Group(const unsigned char* hidden = nullptr);

  /// The grouped faces: face << 3 | permutation code (relevoWeights.glsl), sorted by group, then by
  /// face.
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

  /// The tags of the edges (0,1), (1,2), (0,2) of each face for morphing; empty without morphing.
  const std::vector<float>& GetMorphTags() const { return this->MorphTags; }

  /// Number of triangles of all faces, and of the grouped faces.
  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  vtkIdType GetNumberOfGroupedTriangles() const;

private:
  template <typename GetTags, typename GetStep>
  void SelectFaces(const RefinementMesh& mesh, const PatternFamily& family, float offset,
    int maximumLevel, const GetTags& getTags, const GetStep& getStep);
  void ResizeCounts(const PatternFamily& family);
  void CountFaces(const unsigned char* hidden);
  /// Get the patterns in use.
  void FindPatterns(const PatternFamily& family);

  std::vector<unsigned int> Entries; // entry of the family per face
  std::vector<float> MorphTags;
  RefinementPatterns Patterns;          // by key; nullptr if not in use
  std::vector<std::vector<int>> Counts; // number of faces per key, by chunk of faces
  bool Counted = false;                 // whether all faces are counted
  vtkIdType NumberOfTriangles = 0;
};
}

#endif
