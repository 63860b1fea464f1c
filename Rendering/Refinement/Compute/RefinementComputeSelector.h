// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeSelector
 * @brief   selects patterns in compute shaders and writes draw commands
 *
 * These are the stages "select" and "group" of a frame on the GPU. The input is tags; the output is
 * the faces sorted by pattern and the commands of indirect draws. Nothing is read back. Faces get
 * the same patterns as from PatternSelection for the same tags. The order of faces within a pattern
 * is undefined. A face exactly on the border of the frustum may be hidden by only one of the two.
 *
 * Needs a current context with OpenGL 4.3. Select() and Group() are called between
 * RefinementComputeProgram::Begin() and End(). Private to the module and its tests.
 */
#ifndef RefinementComputeSelector_h
#define RefinementComputeSelector_h

#include "Compute/RefinementComputeBuffer.h"  // for members
#include "Compute/RefinementComputeProgram.h" // for members
#include "RelevoRenderingRefinementModule.h"  // for export macro
#include "vtkType.h"                          // for vtkTypeInt64

#include <string> // for errors
#include <vector> // for data

namespace relevo
{
class RefinementComputeView;

class RELEVORENDERINGREFINEMENT_EXPORT RefinementComputeSelector
{
public:
  RefinementComputeSelector() = default;
  RefinementComputeSelector(const RefinementComputeSelector&) = delete;
  void operator=(const RefinementComputeSelector&) = delete;

  /// Upload a mesh: RefinementFace::Order of each face.
  bool UploadOrders(const std::vector<unsigned char>& orders);

  /// Upload the data for culling: FaceCulling::GetData().
  bool UploadCulling(const std::vector<float>& data);

  /**
   * The ranges of a key's pattern in the buffers to draw from; the same as RelevoPattern of
   * relevoScanCS.glsl.
   */
  struct Pattern
  {
    unsigned int Copies;
    unsigned int NumberOfIndices; // of one copy, like the numbers below
    unsigned int FirstIndex;
    unsigned int FirstVertex;
    unsigned int NumberOfVertices;
    unsigned int FirstLineVertex;
    unsigned int NumberOfLineVertices;
  };

  /**
   * Upload the patterns to select from, by key, and the `table` that selects. For
   * RefinementFace::Order and the levels, 0 to `maximumLevel`, of the sorted edges (0,1), (1,2),
   * (0,2) it contains key << 3 | permutation code. With `morphing`, faces also get the tags for
   * morphing vertices.
   */
  bool UploadPatterns(const std::vector<Pattern>& patterns, const std::vector<unsigned int>& table,
    int maximumLevel, bool morphing);

  /// The element that has a tag. relevoSelectCS.glsl uses the same values.
  enum TagKinds
  {
    UNIFORM = 0,   // no tags: all edges have the highest level
    PER_POINT = 1, // a point; an edge has the mean of its two points
    PER_EDGE = 2   // an edge
  };

  struct Tags
  {
    TagKinds Kind;
    unsigned int Values; // buffer of floats, one per element
    // buffer of each face's points, in sorted order, or edges (0,1), (1,2), (0,2),
    unsigned int Elements;
    int Stride;   // which are the first three of this number of integers
    float Offset; // added to the tags of all edges
  };

  /**
   * Select each face's pattern. Morph tags are written to the buffer `morphTags`, three floats per
   * face.
   */
  bool Select(RefinementComputeView& view, const Tags& tags, unsigned int morphTags);

  /// A camera, with the data of CullingView.
  struct Camera
  {
    static constexpr int NumberOfPlanes = 5;
    float Planes[NumberOfPlanes][4];
    float Eye[3];
    bool Parallel;
    bool HidesBackFaces; // whether faces that face away from the camera are hidden
  };

  /**
   * Sort the visible faces into the buffer `instances`: face << 3 | permutation code. Without a
   * camera, all faces are visible.
   */
  void Group(RefinementComputeView& view, const Camera* camera, unsigned int instances);

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();
  const std::string& GetError() const { return this->Error; }

private:
  bool Fail(const std::string& error);
  bool BuildPrograms();
  void Count(RefinementComputeView& view, const Camera* camera);

  int NumberOfFaces = 0;
  int NumberOfKeys = 0;
  int MaximumLevel = 0;
  bool Morphing = false;
  RefinementComputeProgram SelectProgram;
  RefinementComputeProgram CountProgram;
  RefinementComputeProgram ScanProgram;
  RefinementComputeProgram ScatterProgram;
  RefinementComputeBuffer Orders;
  RefinementComputeBuffer Culling;
  RefinementComputeBuffer Table;
  RefinementComputeBuffer Patterns;
  std::string Error;
};
}

#endif
