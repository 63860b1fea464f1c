// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ARKMethod
 * @brief   a draw call for every face, after the adaptive refinement kernel
 *
 * Boubekeur and Schlick, A Flexible Kernel for Adaptive Mesh Refinement on GPU (2008). The same
 * vertices as ARKFPI's in the same order, so that the pictures are the same to the bit: what
 * differs is that the CPU submits each element. Private to the module.
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
