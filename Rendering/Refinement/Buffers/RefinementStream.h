// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementStream
 * @brief   the refined triangles of a selection, made and kept on the GPU
 *
 * After Lorenz and Doellner, Dynamic Mesh Refinement on GPU using Geometry Shaders (2008): a
 * geometry shader splits triangles once where edges have levels left, and transform feedback hands
 * its triangles to the next pass, from one buffer to another. What is split how is the rule of
 * relevoSplit.glsl; C++ counts by the same rule, so that the buffers are just as large as they must
 * be and nothing is asked of the GPU. Private to the module and its tests.
 */
#ifndef RefinementStream_h
#define RefinementStream_h

#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkType.h"                         // for vtkIdType

#include <string> // for errors
#include <vector> // for vertices

class vtkOpenGLRenderWindow;

namespace relevo
{
class PatternSelection;
class RefinementMesh;
class ViewSelection;
struct FaceSums;

/// A vertex of a triangle: three in a row are one.
struct RefinementStreamVertex
{
  /// The weights of the face's sorted corners; exact.
  float Weights[3];
  /// face << 3 | levels left of the edge to the triangle's next vertex.
  unsigned int Face;
};

/// The pass that RefinementStream repeats.
class RELEVORENDERINGREFINEMENT_EXPORT RefinementSplitProgram
{
public:
  RefinementSplitProgram() = default;
  RefinementSplitProgram(const RefinementSplitProgram&) = delete;
  void operator=(const RefinementSplitProgram&) = delete;

  /// Compile if need be. False when OpenGL does not accept it.
  bool Build(std::string& error);

  /// Split the triangles in one buffer into another, which has room for them.
  void Run(unsigned int source, vtkIdType triangles, unsigned int target) const;

  void ReleaseGraphicsResources();

private:
  unsigned int Handle = 0;
  unsigned int VertexArray = 0;
};

class RELEVORENDERINGREFINEMENT_EXPORT RefinementStream
{
public:
  RefinementStream() = default;
  RefinementStream(const RefinementStream&) = delete;
  void operator=(const RefinementStream&) = delete;

  /**
   * Refine the faces to be drawn to the levels of their edges, which have powers of two of
   * segments. False, with an error, when OpenGL has no room for the triangles.
   */
  bool Refine(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    const PatternSelection& selection, RefinementSplitProgram& program, std::string& error);

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  /// What Refine() makes of the faces that are drawn, and would make of those that are culled.
  static FaceSums CountTriangles(const RefinementMesh& mesh, const ViewSelection& selection);

  /// OpenGL's name of the buffer of RefinementStreamVertex, three per triangle.
  unsigned int GetHandle() const { return this->Handle; }

  /// Wait for the GPU and copy.
  std::vector<RefinementStreamVertex> Read() const;

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();

private:
  unsigned int Handle = 0;
  vtkIdType NumberOfTriangles = 0;
};
}

#endif
