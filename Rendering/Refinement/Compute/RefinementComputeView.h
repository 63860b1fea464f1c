// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeView
 * @brief   what RefinementComputeSelector has found for one view, on the GPU, ready to be drawn
 *
 * Needs a current context with OpenGL 4.3. Private to the module and its tests.
 */
#ifndef RefinementComputeView_h
#define RefinementComputeView_h

#include "Compute/RefinementComputeBuffer.h" // for members
#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkType.h"                         // for vtkTypeInt64

#include <vector> // for data

namespace relevo
{
class RELEVORENDERINGREFINEMENT_EXPORT RefinementComputeView
{
public:
  RefinementComputeView() = default;
  RefinementComputeView(const RefinementComputeView&) = delete;
  void operator=(const RefinementComputeView&) = delete;

  /// Take room. False when shaders of this context cannot reach so much.
  bool Resize(int numberOfFaces, int numberOfKeys);

  /// How patterns are drawn; all but triangles without copies.
  enum Primitives
  {
    TRIANGLES,
    LINES,
    POINTS,
    CORNERS // as points
  };

  /**
   * Draw all faces. The vertex array in use has the patterns and, per instance, GetMembers().
   */
  void Draw(Primitives primitives) const;

  /**
   * Buffer with each instance's faces: number of the first among the sorted faces, how many.
   */
  unsigned int GetMembers(Primitives primitives);

  //@{
  /**
   * Wait for the GPU and copy: each face's key << 3 | permutation code; its rank among the faces of
   * its key, or NotDrawn; how many faces of each key are drawn; the commands by key, as OpenGL
   * defines them.
   */
  std::vector<unsigned int> ReadEntries() const;
  static constexpr unsigned int NotDrawn = 0xffffffffu; // as in relevoGroupCS.glsl
  std::vector<unsigned int> ReadRanks() const;
  std::vector<unsigned int> ReadCounts() const;
  std::vector<unsigned int> ReadCommands(Primitives primitives) const;
  //@}

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();

private:
  friend class RefinementComputeSelector;

  size_t GetFirstCommand(Primitives primitives) const;

  int NumberOfFaces = 0;
  int NumberOfKeys = 0;
  RefinementComputeBuffer Entries;
  RefinementComputeBuffer Counts;
  RefinementComputeBuffer Ranks; // of a face among those of its key
  RefinementComputeBuffer Groups;
  RefinementComputeBuffer Members;
  RefinementComputeBuffer Singles; // members of what is drawn without copies, made when needed
  RefinementComputeBuffer Triangles;
  RefinementComputeBuffer Others;
};
}

#endif
