// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeSelector
 * @brief   PatternSelection in compute shaders, that ends in draw commands
 *
 * The stages select and group of a frame on the GPU: tags go in; out come the faces sorted by
 * pattern and the commands of indirect draws. Nothing comes back. Faces get the patterns that
 * PatternSelection gives them for the same tags. Within a pattern the order of the faces is
 * undefined, and a face at the very border of what a camera sees may be hidden by one and not by
 * the other.
 *
 * Needs a current context with OpenGL 4.3; Select() and Group() are called between
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

  /// Take a mesh: RefinementFace::Order of each face.
  bool UploadOrders(const std::vector<unsigned char>& orders);

  /// Take what decides which faces are hidden: FaceCulling::GetData().
  bool UploadCulling(const std::vector<float>& data);

  /**
   * Where a key's pattern lies in the buffers that are drawn from; RelevoPattern of
   * relevoScanCS.glsl.
   */
  struct Pattern
  {
    unsigned int Copies;
    unsigned int NumberOfIndices; // of one copy, as all numbers here
    unsigned int FirstIndex;
    unsigned int FirstVertex;
    unsigned int NumberOfVertices;
    unsigned int FirstLineVertex;
    unsigned int NumberOfLineVertices;
  };

  /**
   * Take the patterns to choose from, by key, and the `table` that chooses: for
   * RefinementFace::Order and the levels, 0 to `maximumLevel`, of the sorted edges (0,1), (1,2),
   * (0,2) it has key << 3 | permutation code. With `morphing` faces also get the tags that vertices
   * morph by.
   */
  bool UploadPatterns(const std::vector<Pattern>& patterns, const std::vector<unsigned int>& table,
    int maximumLevel, bool morphing);

  /// What tags belong to; the values are those of relevoSelectCS.glsl.
  enum TagKinds
  {
    UNIFORM = 0,   // nothing: all edges have the highest level
    PER_POINT = 1, // an element is a point, and an edge has the mean of its two
    PER_EDGE = 2   // an element is an edge
  };

  struct Tags
  {
    TagKinds Kind;
    unsigned int Values;   // buffer of floats, by element
    unsigned int Elements; // buffer of each face's points, sorted by place, or edges (0,1), (1,2),
    int Stride;            // (0,2), as the first three of so many integers
    float Offset;          // added to the tags of all edges
  };

  /**
   * Choose each face's pattern. Morph tags go to the buffer `morphTags`, three floats a face.
   */
  bool Select(RefinementComputeView& view, const Tags& tags, unsigned int morphTags);

  /// A camera as CullingView has it.
  struct Camera
  {
    static constexpr int NumberOfPlanes = 5;
    float Planes[NumberOfPlanes][4];
    float Eye[3];
    bool Parallel;
    bool HidesBackFaces; // whether faces that face away are hidden
  };

  /**
   * Sort the faces, those not hidden from the camera if there is one, into the buffer `instances`:
   * face << 3 | permutation code.
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
