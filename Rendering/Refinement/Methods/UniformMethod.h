// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   UniformMethod
 * @brief   draws each face with the uniform pattern of the highest level, instanced
 *
 * After Boubekeur and Schlick, Generic Mesh Refinement on GPU (2005), with instances instead of
 * draw calls. Private to the module.
 */
#ifndef UniformMethod_h
#define UniformMethod_h

#include "Buffers/InstanceBuffers.h"     // for members
#include "Evaluation/PatternSelection.h" // for PatternGroup
#include "Methods/PatternMethod.h"

#include <map> // for members

namespace relevo
{
class UniformMethod : public PatternMethod
{
public:
  DrawnLevels GetDrawnLevels() const override { return DrawnLevels::HIGHEST; }
  bool Upload(const RefinementDrawing& drawing) override;
  void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const override;
  int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) override;
  bool CountTriangles(const RefinementDrawing& drawing, FaceSums& sums) const override;
  vtkTypeInt64 GetMemorySize() const override { return this->Instances.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  /// Return the number of segments per edge of a face's pattern; `most` is the largest number of
  /// any edge of the mesh.
  virtual int GetSegments(const PatternSelection& selection, int face, int most) const;

private:
  void Group(const RefinementDrawing& drawing, std::vector<unsigned int>& instances,
    std::vector<PatternGroup>& groups) const;

  InstanceBuffers Instances;
  struct Slot
  {
    std::vector<PatternGroup> Groups;
    vtkMTimeType GroupsTime = 0;
  };
  std::map<int, Slot> Slots;
};
}

#endif
