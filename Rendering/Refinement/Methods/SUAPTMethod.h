// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SUAPTMethod
 * @brief   semi-uniform adaptive patches: uniform patterns, snapped to coarser edges in the shader
 *
 * Each face is drawn, instanced, with the uniform pattern of its finest edge. The vertices on its
 * other edges move to the points of those edges (compared in Lenz 2009). The degenerate triangles
 * that this leaves are drawn. Private to the module.
 */
#ifndef SUAPTMethod_h
#define SUAPTMethod_h

#include "Buffers/RefinementEdgeSegments.h" // for members
#include "Methods/UniformMethod.h"

namespace relevo
{
class SUAPTMethod : public UniformMethod
{
public:
  DrawnLevels GetDrawnLevels() const override { return DrawnLevels::ROUNDED; }
  bool Upload(const RefinementDrawing& drawing) override;
  void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
  vtkTypeInt64 GetMemorySize() const override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  int GetSegments(const PatternSelection& selection, int face, int most) const override;

private:
  RefinementEdgeSegments Edges;
};
}

#endif
