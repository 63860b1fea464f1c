// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementEdgeSegments.h"

#include "Mesh/RefinementMesh.h"
#include "State/ViewSelection.h"
#include "vtkOpenGLRenderWindow.h"

namespace relevo
{
bool RefinementEdgeSegments::Upload(vtkOpenGLRenderWindow* window, int slot,
  const RefinementMesh& mesh, const ViewSelection& selection)
{
  this->Current = &this->Slots[slot];
  if (this->Current->LevelsTime == selection.GetLevelsTime())
  {
    return true;
  }
  std::vector<unsigned int> packed(mesh.Faces.size());
  for (size_t f = 0; f < packed.size(); ++f)
  {
    int segments[3];
    selection.GetSelection().GetFacePattern(static_cast<int>(f)).GetEdgeSegments(segments);
    packed[f] = static_cast<unsigned int>(segments[0] | segments[1] << 8 | segments[2] << 16 |
      (mesh.Faces[f].IsTurned() ? 1 << 24 : 0));
  }
  if (!this->Current->Segments.Upload(window, packed))
  {
    return false;
  }
  this->Current->LevelsTime = selection.GetLevelsTime();
  return true;
}

void RefinementEdgeSegments::Activate(vtkShaderProgram* program)
{
  if (this->Current)
  {
    this->Current->Segments.Activate(program, "relevoEdgeSegments");
  }
}

void RefinementEdgeSegments::Deactivate()
{
  if (this->Current)
  {
    this->Current->Segments.Deactivate();
  }
}

vtkTypeInt64 RefinementEdgeSegments::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const auto& slot : this->Slots)
  {
    size += slot.second.Segments.GetMemorySize();
  }
  return size;
}

void RefinementEdgeSegments::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& slot : this->Slots)
  {
    slot.second.Segments.ReleaseGraphicsResources(window);
  }
  this->Slots.clear();
  this->Current = nullptr;
}
}
