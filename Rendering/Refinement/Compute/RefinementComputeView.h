// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeView
 * @brief   the result of RefinementComputeSelector for one view, on the GPU, ready to be drawn
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

  /// Allocate the buffers. Return false if shaders of this context cannot access that many bytes.
  bool Resize(int numberOfFaces, int numberOfKeys);

  /// The primitives of patterns. All except triangles are drawn without copies.
  enum Primitives
  {
    TRIANGLES,
    LINES,
    POINTS,
    CORNERS // as points
  };

  /**
   * Draw all faces. The current vertex array has the patterns and, per instance, GetMembers().
   */
  void Draw(Primitives primitives) const;

  /**
   * Return the buffer of each instance's faces: the index of the first among the sorted faces, and
   * the number of faces.
   */
  unsigned int GetMembers(Primitives primitives);

  //@{
  /**
   * Wait for the GPU and copy: for each face, key << 3 | permutation code; for each face, its rank
   * among the faces of its key, or NotDrawn; for each key, the number of drawn faces; for each key,
   * the draw commands as OpenGL defines them.
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
  RefinementComputeBuffer Ranks; // rank of a face among those of its key
  RefinementComputeBuffer Groups;
  RefinementComputeBuffer Members;
  RefinementComputeBuffer Singles; // members for drawing without copies, created on demand
  RefinementComputeBuffer Triangles;
  RefinementComputeBuffer Others;
};
}

#endif
