// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHardwareTessellation.h"

#include "vtkRelevoOpenGL.h"

#include "relevoEdgeSegments.h"
#include "relevoTessellationTCS.h"
#include "relevoTessellationTES.h"
#include "relevoTessellationVS.h"

#include "vtkRefinementComputeState.h"
#include "vtkRefinementInstances.h"
#include "vtkRefinementPattern.h"
#include "vtkRefinementShader.h"
#include "vtkShaderProgram.h"
#include "vtkViewSelection.h"

#include <algorithm>
#include <limits>

namespace relevo
{
namespace
{
// Vertices that one call may make of its patches: Mesa's tessellator on the CPU counts in 16 bits,
// and has faces missing from there on.
vtkIdType GetMostVertices()
{
  return RefinementComputeState::IsHardware() ? std::numeric_limits<vtkIdType>::max() : 65535;
}

void Limit(const int segments[3], int limited[3])
{
  for (int e = 0; e < 3; ++e)
  {
    limited[e] = std::min<int>(segments[e], HardwareTessellation::MostSegments);
  }
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
  // Rings from the outside in: between the m segments of a ring's side and the n of the next
  // ring's lie m + n triangles, and n is two less than the ring would have. What is left is a point
  // or one triangle.
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
  // By Euler: the triangles have three sides each, of which all but the border's are shared.
  return 1 + (CountTriangles(segments) + outer[0] + outer[1] + outer[2]) / 2;
}

std::string HardwareTessellation::GetMissing() const
{
  return TessellationPrograms::AreSupported() ? "" : "OpenGL 4.0";
}

bool HardwareTessellation::Upload(const RefinementDrawing& drawing)
{
  const bool uploaded =
    drawing.Instances->Upload(drawing.Window, drawing.Slot, *drawing.Selection) &&
    this->Segments.Upload(drawing.Window, drawing.Slot, *drawing.Mesh, *drawing.Selection);
  this->Error = uploaded ? "" : RefinementBuffer::GetTooLarge();
  return uploaded;
}

void HardwareTessellation::Describe(
  const RefinementDrawing&, RefinementShaderOptions& options) const
{
  options.PlacementSource = std::string(relevoEdgeSegments) + relevoTessellationTES;
}

vtkShaderProgram* HardwareTessellation::BuildProgram(
  const RefinementDrawing& drawing, const std::map<vtkShader::Type, vtkShader*>& shaders)
{
  const std::string control = "#define RELEVO_MOST_SEGMENTS " + std::to_string(MostSegments) +
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
  int calls = 0;
  GLint first = 0;
  GLint end = 0;
  vtkIdType vertices = 0;
  auto draw = [&]()
  {
    if (end > first)
    {
      glDrawArrays(GL_PATCHES, first, end - first);
      ++calls;
    }
    first = end;
    vertices = 0;
  };
  const vtkIdType most = GetMostVertices();
  for (const PatternGroup& group : drawing.Selection->GetSelection().Groups)
  {
    const vtkIdType perFace = CountVertices(group.Pattern->Segments);
    while (end < group.Offset + group.Count)
    {
      if (perFace > most - vertices)
      {
        draw();
      }
      const vtkIdType faces = std::min<vtkIdType>(
        group.Offset + group.Count - end, std::max<vtkIdType>(1, (most - vertices) / perFace));
      end += static_cast<GLint>(faces);
      vertices += faces * perFace;
    }
  }
  draw();
  this->Segments.Deactivate();
  drawing.Instances->Deactivate();
  return calls;
}

vtkIdType HardwareTessellation::GetNumberOfTriangles(const RefinementDrawing& drawing) const
{
  vtkIdType triangles = 0;
  for (const PatternGroup& group : drawing.Selection->GetSelection().Groups)
  {
    triangles += group.Count * CountTriangles(group.Pattern->Segments);
  }
  return triangles;
}

void HardwareTessellation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Segments.ReleaseGraphicsResources(window);
  this->Programs.ReleaseGraphicsResources(window);
}
}
