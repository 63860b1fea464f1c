// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/UniformMethod.h"

#include "relevoInstancedVS.h"
#include "relevoPatternVS.h"
#include "relevoPermutedVS.h"

#include "Mesh/RefinementMesh.h"
#include "Patterns/PatternLibrary.h"
#include "Patterns/RefinementPattern.h"
#include "Shaders/RefinementShader.h"
#include "State/ViewSelection.h"

#include <algorithm>

namespace relevo
{
namespace
{
int GetMaximumSegments(const PatternSelection& selection)
{
  int most = 1;
  for (int face = 0; face < selection.GetNumberOfFaces(); ++face)
  {
    const int* segments = selection.GetFacePattern(face).Pattern->Segments;
    most = std::max(most, *std::max_element(segments, segments + 3));
  }
  return most;
}
}

int UniformMethod::GetSegments(const PatternSelection&, int, int most) const
{
  return most;
}

void UniformMethod::Group(const RefinementDrawing& drawing, std::vector<unsigned int>& instances,
  std::vector<PatternGroup>& groups) const
{
  const PatternSelection& selection = drawing.Selection->GetSelection();
  const int most = GetMaximumSegments(selection);
  // A uniform pattern is the same for all orders of the corners, except for the winding.
  std::vector<std::vector<unsigned int>> faces(2 * (static_cast<size_t>(most) + 1));
  for (unsigned int instance : selection.Instances)
  {
    const unsigned int face = instance >> 3;
    const int n = this->GetSegments(selection, static_cast<int>(face), most);
    faces[static_cast<size_t>(2 * n + (drawing.Mesh->Faces[face].IsTurned() ? 1 : 0))].push_back(
      face << 3);
  }
  for (size_t key = 0; key < faces.size(); ++key)
  {
    if (faces[key].empty())
    {
      continue;
    }
    const int n = static_cast<int>(key / 2);
    groups.push_back({ drawing.Library->GetPatternOfSegments(n, n, n), key % 2 == 1,
      static_cast<int>(instances.size()), static_cast<int>(faces[key].size()) });
    instances.insert(instances.end(), faces[key].begin(), faces[key].end());
  }
}

bool UniformMethod::Upload(const RefinementDrawing& drawing)
{
  Slot& slot = this->Slots[drawing.Slot];
  const vtkMTimeType time = drawing.Selection->GetGroupsTime();
  std::vector<unsigned int> instances;
  if (slot.GroupsTime != time)
  {
    slot.GroupsTime = 0;
    slot.Groups.clear();
    this->Group(drawing, instances, slot.Groups);
  }
  drawing.Patterns->Load(*drawing.Library, slot.Groups, drawing.HasLines);
  if (!this->Instances.Upload(drawing.Window, drawing.Slot, instances, time))
  {
    return this->FailForSize();
  }
  slot.GroupsTime = time;
  return true;
}

void UniformMethod::FillOptions(const RefinementDrawing&, RefinementShaderOptions& options) const
{
  options.PlacementSource = std::string(relevoPatternVS) + relevoInstancedVS + relevoPermutedVS;
}

int UniformMethod::Draw(
  const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives)
{
  this->Instances.Activate(program);
  const BoundPatterns patterns(drawing, program, primitives);
  const int calls = DrawGroups(drawing, program, primitives, this->Slots.at(drawing.Slot).Groups);
  this->Instances.Deactivate();
  return calls;
}

bool UniformMethod::CountTriangles(const RefinementDrawing& drawing, FaceSums& sums) const
{
  const PatternSelection& selection = drawing.Selection->GetSelection();
  const int most = GetMaximumSegments(selection);
  sums = drawing.Selection->SumOverFaces(
    [&](int face)
    {
      const vtkIdType n = this->GetSegments(selection, face, most);
      return n * n;
    });
  return true;
}

void UniformMethod::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Instances.ReleaseGraphicsResources(window);
  this->Slots.clear();
}
}
