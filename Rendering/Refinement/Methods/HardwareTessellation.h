// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HardwareTessellation
 * @brief   faces as patches that OpenGL's tessellator cuts up
 *
 * One draw call for all faces, each of them a patch; where OpenGL runs on the CPU several, because
 * Mesa counts the vertices of one in 16 bits. The tessellation control shader asks for as
 * many segments on each edge as the selection has, and inside for as many as on the edge that has
 * most; the evaluation shader is VTK's refining vertex shader.
 *
 * Inside, the largest number makes the best triangles. An equilateral face whose edges agree or
 * differ by one level has no angle below 30 degrees; the mean, two thirds of the largest and other
 * rules leave slivers below 7 degrees there, the smallest and the middle one angles of 19 degrees.
 * It costs: with n segments at most on an edge the tessellator makes about 1.5 n^2 triangles, where
 * a pattern has n^2 at most.
 *
 * Points on edges are moved to the exact fractions that patterns have, whatever the tessellator
 * makes of them, so that faces share them to the bit. Private to the module and its tests.
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
  /// The most segments that every OpenGL can cut an edge into. Edges of more have so many.
  static constexpr int MaximumSegments = 64;

  /**
   * Triangles that OpenGL makes of a triangular patch with equal spacing (OpenGL 4.0 core profile,
   * section 2.12.2), for the segments of its edges and the rule for the inside above.
   */
  static vtkIdType CountTriangles(const int segments[3]);
  /// The vertices of these triangles.
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
