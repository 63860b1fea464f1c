// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HardwareTessellation
 * @brief   draws faces as patches that OpenGL's tessellator subdivides
 *
 * One draw call draws all faces, each as a patch. If OpenGL runs on the CPU, several calls are
 * needed, because Mesa counts the vertices of a call in 16 bits. The tessellation control shader
 * sets the outer levels to the segments of the edges, and the inner level to the largest of them.
 * The evaluation shader is VTK's refining vertex shader.
 *
 * The largest inner level gives the best triangles. An equilateral face whose edges agree or differ
 * by one level has no angle below 30 degrees. The mean, two thirds of the largest and other rules
 * leave slivers below 7 degrees; the smallest and the middle number leave angles of 19 degrees. The
 * price: with at most n segments on an edge the tessellator generates about 1.5 n^2 triangles,
 * while a pattern has at most n^2.
 *
 * Points on edges are moved from the tessellator's coordinates to the exact fractions that patterns
 * have, so that neighbouring faces share them bit by bit. Private to the module and its tests.
 */
#ifndef HardwareTessellation_h
#define HardwareTessellation_h

#include "Buffers/RefinementEdgeSegments.h" // for members
#include "Methods/RefinementMethod.h"
#include "RelevoRenderingRefinementModule.h" // for export macro
#include "Shaders/TessellationPrograms.h"    // for members

namespace relevo
{
class RELEVORENDERINGREFINEMENT_EXPORT HardwareTessellation : public RefinementMethod
{
public:
  /// The number of segments per edge that every OpenGL supports. Finer edges get this number.
  static constexpr int MaximumSegments = 64;

  /**
   * Return the number of triangles that OpenGL generates from a triangular patch with equal spacing
   * (OpenGL 4.0 core profile, section 2.12.2), for the segments of its edges and the inner level
   * described above.
   */
  static vtkIdType CountTriangles(const int segments[3]);
  /// Return the number of vertices of these triangles.
  static vtkIdType CountVertices(const int segments[3]);

  std::string GetMissing() const override;
  bool CanDraw(Primitives primitives) const override { return primitives == Primitives::TRIANGLES; }
  bool HasPatterns() const override { return false; }
  bool HasStages() const override { return true; }
  bool Upload(const RefinementDrawing& drawing) override;
  void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  vtkShaderProgram* BuildProgram(const RefinementDrawing& drawing,
    const std::map<vtkShader::Type, vtkShader*>& shaders) override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
  bool CountTriangles(const RefinementDrawing& drawing, FaceSums& sums) const override;
  vtkTypeInt64 GetMemorySize() const override { return this->Segments.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  RefinementEdgeSegments Segments;
  TessellationPrograms Programs;
};
}

#endif
