// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ARKMethod
 * @brief   draws each face with one draw call: the adaptive refinement kernel
 *
 * Boubekeur and Schlick, A Flexible Kernel for Adaptive Mesh Refinement on GPU (2008). The vertices
 * and their order are those of ARKFPI, so that images are bit-identical. The only difference is
 * that the CPU submits each face. Private to the module.
 */
#ifndef ARKMethod_h
#define ARKMethod_h

#include "Methods/PatternMethod.h"

namespace relevo
{
class ARKMethod : public PatternMethod
{
public:
  DrawnLevels GetDrawnLevels() const override { return DrawnLevels::MORPHED; }
  bool Upload(const RefinementDrawing& drawing) override;
  void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
};
}

#endif
