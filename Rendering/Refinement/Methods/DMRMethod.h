// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DMRMethod
 * @brief   dynamic mesh refinement with a geometry shader and transform feedback
 *
 * After Lorenz and Doellner (2008). The mesh is refined once per selection (RefinementStream) and
 * then drawn as triangles. Private to the module.
 */
#ifndef DMRMethod_h
#define DMRMethod_h

#include "Buffers/RefinementStream.h" // for members
#include "Methods/RefinementMethod.h"

#include <map> // for members

namespace relevo
{
class DMRMethod : public RefinementMethod
{
public:
  std::string FindError(const PatternFamily& family) const override;
  bool CanDraw(Primitives primitives) const override;
  bool HasPatterns() const override { return false; }
  bool Upload(const RefinementDrawing& drawing) override;
  void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
  bool CountTriangles(const RefinementDrawing& drawing, FaceSums& sums) const override;
  vtkTypeInt64 GetMemorySize() const override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  struct Slot
  {
    RefinementStream Stream;
    vtkMTimeType GroupsTime = 0;
  };
  std::map<int, Slot> Slots;
  RefinementSplitProgram Program;
};
}

#endif
