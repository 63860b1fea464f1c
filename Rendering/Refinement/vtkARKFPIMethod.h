// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkARKFPIMethod
 * @brief   an instanced draw call for all faces that share a base pattern (Lenz 2009)
 *
 * Private to the module.
 */
#ifndef vtkARKFPIMethod_h
#define vtkARKFPIMethod_h

#include "vtkPatternMethod.h"

namespace relevo
{
class ARKFPIMethod : public PatternMethod
{
public:
  bool TakesComputeSelection() const override { return true; }
  bool Upload(const RefinementDrawing& drawing) override;
  void Describe(const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
};
}

#endif
