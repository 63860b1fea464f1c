// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/HardwareTessellation.h"

#include "OpenGL/ContextFacts.h"
#include "OpenGL/RelevoOpenGL.h"

#include "relevoEdgeSegments.h"
#include "relevoTessellationTCS.h"
#include "relevoTessellationTES.h"
#include "relevoTessellationVS.h"

#include "Buffers/InstanceBuffers.h"
#include "Patterns/RefinementPattern.h"
#include "Shaders/RefinementShaderOptions.h"
#include "State/ViewSelection.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
void Limit(const int segments[3], int limited[3])
{
  for (int e = 0; e < 3; ++e)
  {
    limited[e] = std::min<int>(segments[e], HardwareTessellation::MaximumSegments);
  }
}

// Return the ends of the groups of faces that are drawn together.
std::vector<GLint> FindEnds(const std::vector<PatternGroup>& groups)
{
  // Mesa's tessellator on the CPU counts the vertices of a call in 16 bits, and further faces are
  // missing.
  const vtkIdType most = IsHardwareRenderer() ? std::numeric_limits<vtkIdType>::max() : 65535;
  std::vector<GLint> ends;
  GLint end = 0;
  vtkIdType vertices = 0;
  for (const PatternGroup& group : groups)
  {
    const vtkIdType perFace = HardwareTessellation::CountVertices(group.Pattern->Segments);
    while (end < group.Offset + group.Count)
    {
      if (perFace > most - vertices)
      {
        ends.push_back(end);
        vertices = 0;
      }
      const vtkIdType faces =
        std::min<vtkIdType>(group.Offset + group.Count - end, (most - vertices) / perFace);
      end += static_cast<GLint>(faces);
      vertices += faces * perFace;
    }
  }
  if (end > 0)
  {
    ends.push_back(end);
  }
  return ends;
}
}

vtkIdType HardwareTessellation::CountTriangles(const int segments[3])
{
  int outer[3];
  Limit(segments, outer);
  int inner = *std::max_element(outer, outer + 3);
  if (inner == 1)
  {
    return 1;
  }
  // Count rings from the outside to the centre. Between the m segments of a ring's side and the n
  // of the next ring's there are m + n triangles, and the number decreases by two from ring to
  // ring. A point or a triangle remains.
  vtkIdType triangles = outer[0] + outer[1] + outer[2] + 3 * (inner - 2);
  for (inner -= 2; inner > 1; inner -= 2)
  {
    triangles += 3 * (inner + inner - 2);
  }
  return triangles + inner;
}

vtkIdType HardwareTessellation::CountVertices(const int segments[3])
{
  int outer[3];
  Limit(segments, outer);
  // This follows from Euler's formula: triangles have three sides, which are shared except on the
  // border.
  return 1 + (CountTriangles(segments) + outer[0] + outer[1] + outer[2]) / 2;
}

std::string HardwareTessellation::GetMissing() const
{
  return TessellationPrograms::AreSupported() ? "" : "OpenGL 4.0";
}

bool HardwareTessellation::Upload(const RefinementDrawing& drawing)
{
  return (UploadInstances(drawing) &&
           this->Segments.Upload(
             drawing.Window, drawing.Slot, *drawing.Mesh, *drawing.Selection)) ||
    this->FailForSize();
}

void HardwareTessellation::FillOptions(
  const RefinementDrawing&, RefinementShaderOptions& options) const
{
  options.PlacementSource = std::string(relevoEdgeSegments) + relevoTessellationTES;
}

vtkShaderProgram* HardwareTessellation::BuildProgram(
  const RefinementDrawing& drawing, const std::map<vtkShader::Type, vtkShader*>& shaders)
{
  const std::string control = "#define RELEVO_MOST_SEGMENTS " + std::to_string(MaximumSegments) +
    "\n" + relevoEdgeSegments + relevoTessellationTCS;
  vtkShaderProgram* program =
    this->Programs.Build(drawing.Window, relevoTessellationVS, control, shaders);
  this->Error = this->Programs.GetError();
  return program;
}

int HardwareTessellation::Draw(
  const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives)
{
  drawing.Instances->Activate(program);
  this->Segments.Activate(program);
  glPatchParameteri(GL_PATCH_VERTICES, 1);
  const std::vector<GLint> ends = FindEnds(drawing.Selection->GetSelection().Groups);
  GLint first = 0;
  for (GLint end : ends)
  {
    glDrawArrays(GL_PATCHES, first, end - first);
    first = end;
  }
  this->Segments.Deactivate();
  drawing.Instances->Deactivate();
  return static_cast<int>(ends.size());
}

bool HardwareTessellation::CountTriangles(const RefinementDrawing& drawing, FaceSums& sums) const
{
  const PatternSelection& selection = drawing.Selection->GetSelection();
  sums = drawing.Selection->SumOverFaces([&selection](int face)
    { return CountTriangles(selection.GetFacePattern(face).Pattern->Segments); });
  return true;
}

void HardwareTessellation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Segments.ReleaseGraphicsResources(window);
  this->Programs.ReleaseGraphicsResources(window);
}
}
