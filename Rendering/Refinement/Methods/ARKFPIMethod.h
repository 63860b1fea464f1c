// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ARKFPIMethod
 * @brief   an instanced draw call for all faces that share a base pattern (Lenz 2009)
 */
#ifndef ARKFPIMethod_h
#define ARKFPIMethod_h

#include "Methods/PatternMethod.h"

namespace relevo
{
class ARKFPIMethod : public PatternMethod
{
public:
  DrawnLevels GetDrawnLevels() const override { return DrawnLevels::MORPHED; }
  bool TakesComputeSelection() const override { return true; }
  bool Upload(const RefinementDrawing& drawing) override;
  void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
};
}

#endif
