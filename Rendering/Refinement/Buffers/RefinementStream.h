// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementStream
 * @brief   the refined triangles of a selection, generated and stored on the GPU
 *
 * After Lorenz and Doellner, Dynamic Mesh Refinement on GPU using Geometry Shaders (2008): in each
 * pass a geometry shader splits the triangles whose edges have levels left, and transform feedback
 * writes the result to the buffer that the next pass reads. relevoSplit.glsl defines the split. C++
 * counts triangles by the same rule, so that the buffers have the exact size and nothing is read
 * back from the GPU. Private to the module and its tests.
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

/// A vertex of a triangle; three consecutive vertices are a triangle.
struct RefinementStreamVertex
{
  /// The exact weights of the face's sorted corners.
  float Weights[3];
  /// face << 3 | levels left on the edge to the triangle's next vertex.
  unsigned int Face;
};

/// The program of a pass, which RefinementStream repeats.
class RELEVORENDERINGREFINEMENT_EXPORT RefinementSplitProgram
{
public:
  RefinementSplitProgram() = default;
  RefinementSplitProgram(const RefinementSplitProgram&) = delete;
  void operator=(const RefinementSplitProgram&) = delete;

  /// Compile the program, unless that has been done. Return false if OpenGL does not accept it.
  bool Build(std::string& error);

  /// Split the triangles in one buffer into another, which must be large enough.
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
   * Refine the drawn faces to the levels of their edges, whose segments are powers of two. Return
   * false and set an error if OpenGL lacks memory for the triangles.
   */
  bool Refine(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    const PatternSelection& selection, RefinementSplitProgram& program, std::string& error);

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  /// Return the number of triangles that Refine() generates from the drawn faces, and that it would
  /// generate from the culled ones.
  static FaceSums CountTriangles(const RefinementMesh& mesh, const ViewSelection& selection);

  /// Return OpenGL's name of the buffer of RefinementStreamVertex, three per triangle.
  unsigned int GetHandle() const { return this->Handle; }

  /// Wait for the GPU and copy the vertices.
  std::vector<RefinementStreamVertex> Read() const;

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();

private:
  unsigned int Handle = 0;
  vtkIdType NumberOfTriangles = 0;
};
}

#endif
