// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurvePainter.h"

#include "OpenGL/ContextFacts.h"
#include "OpenGL/RelevoOpenGL.h"

#include "Actors/ShaderVariantKey.h"
#include "Drawing/CurveScalars.h"
#include "OpenGL/PositionShift.h"
#include "relevoTessellationVS.h"
#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <limits>

namespace relevo
{
namespace
{
// The number of segments that every OpenGL's tessellator supports.
constexpr int MaximumTessellated = 64;

CurvePatterns::Primitives GetPlainPrimitives(int sides)
{
  return sides == 1 ? CurvePatterns::LINES : CurvePatterns::TRIANGLES;
}

CurvePatterns::Primitives GetPrimitives(int sides, vtkActor* actor)
{
  switch (actor->GetProperty()->GetRepresentation())
  {
    case VTK_POINTS:
      return CurvePatterns::POINTS;
    case VTK_WIREFRAME:
      return CurvePatterns::LINES;
    default:
      return GetPlainPrimitives(sides);
  }
}

GLint FindGroupUniform(vtkShaderProgram* program)
{
  return glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "relevoGroup");
}

GLenum GetMode(CurvePatterns::Primitives primitives)
{
  return primitives == CurvePatterns::POINTS ? GL_POINTS
    : primitives == CurvePatterns::LINES     ? GL_LINES
                                             : GL_TRIANGLES;
}
}

vtkStandardNewMacro(CurvePainter);

CurvePainter::CurvePainter()
{
  this->SetVBOShiftScaleMethod(
    static_cast<int>(vtkOpenGLVertexBufferObject::ShiftScaleMethod::MANUAL_SHIFT_SCALE));
}

CurvePainter::~CurvePainter() = default;

//------------------------------------------------------------------------------
// Curves

bool CurvePainter::SetCurves(vtkPointSet* input)
{
  const bool hasChanged = this->Geometry.SetCurves(input);
  if (hasChanged)
  {
    this->ColorSource.Clear();
  }
  return hasChanged;
}

std::string CurvePainter::SetShape(const CurveGeometry::Shape& shape)
{
  if (this->Geometry.SetShape(shape))
  {
    this->UpdateBox();
  }
  return this->Geometry.GetRadiusError();
}

void CurvePainter::UpdateBox()
{
  double bounds[6];
  this->GetCurveBounds(bounds);
  this->Box->Initialize();
  this->Box->SetPoints(vtkNew<vtkPoints>());
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    this->Box->GetPoints()->InsertNextPoint(bounds[0], bounds[2], bounds[4]);
    this->Box->GetPoints()->InsertNextPoint(bounds[1], bounds[3], bounds[5]);
    vtkNew<vtkFloatArray> normals; // VTK lights lines only if they have normals
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(2);
    normals->Fill(0.0);
    this->Box->GetPointData()->SetNormals(normals);
  }
}

//------------------------------------------------------------------------------
// Selection for a view

std::string CurvePainter::Prepare(vtkRenderer* renderer, vtkActor* actor, const Settings& settings)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->NumberOfDrawCalls = 0;
  const std::string error =
    this->Geometry.Select(settings.Recipe, renderer, actor, settings.IsCulled);
  if (!error.empty())
  {
    return error;
  }
  const bool isSelecting = renderer->GetSelector() != nullptr;
  if (!this->Geometry.Upload(window, isSelecting))
  {
    return "Cannot draw the input: " + BufferTexture::GetTooLarge() + ".";
  }
  this->UpdateColors(window, settings.Scalars);
  const int sides = this->Geometry.GetSides();
  const CurveBuffers& buffers = this->Geometry.GetBuffers();
  this->Variants.GetHelper().PrimitiveType = sides == 1 ? PrimitiveLines : PrimitiveTris;
  this->Options.Sides = sides;
  this->Options.Degree = buffers.GetDegree();
  this->Options.IsRational = buffers.IsRational();
  this->Options.HasRadii = sides > 1 && buffers.HasRadii();
  this->Options.Coloring = this->Colors.GetColoring();
  this->ChooseMethod(actor, settings.IsTessellated);
  return "";
}

void CurvePainter::UpdateColors(vtkOpenGLRenderWindow* window, vtkMapper* scalars)
{
  Dependencies source = GetScalarSettings(scalars);
  if (this->ColorSource.Update(source))
  {
    this->ColorError = UploadScalars(
      window, scalars, this->Geometry.GetInput(), this->Geometry.GetMesh(), this->Colors);
    this->ColorSource = GetScalarSettings(scalars); // after mapping, which sets the table's range
    if (!this->ColorError.empty())
    {
      this->Colors.Clear(window);
    }
  }
}

void CurvePainter::ChooseMethod(vtkActor* actor, bool isTessellated)
{
  const int sides = this->Options.Sides;
  this->Options.IsTessellated = false;
  this->TessellationError.clear();
  if (!isTessellated || GetPrimitives(sides, actor) != GetPlainPrimitives(sides))
  {
    return;
  }
  if (!TessellationPrograms::AreSupported())
  {
    this->TessellationError = "it needs OpenGL 4.0, which this OpenGL context does not have";
    return;
  }
  this->Options.IsTessellated = this->FailedStages.IsEmpty() ||
    this->FailedStages != Dependencies::On(actor->GetShaderProperty()->GetShaderMTime());
}

//------------------------------------------------------------------------------
// Drawing

void CurvePainter::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Geometry.GetSelection().GetGroups().empty() || this->PointPicking)
  {
    return;
  }
  vtkOpenGLHelper& helper = this->Variants.GetHelper();
  if (!this->UpdateProgram(helper, this->Options.GetKey(), renderer, actor))
  {
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const CurvePatterns::Primitives primitives = GetPrimitives(this->Options.Sides, actor);
  if (primitives == CurvePatterns::LINES && !this->HaveWideLines(renderer, actor))
  {
    window->GetState()->vtkglLineWidth(actor->GetProperty()->GetLineWidth());
  }
  helper.VAO->Bind(); // VTK releases it when the program changes
  this->Geometry.ActivateInstances(helper.Program);
  if (this->Options.IsTessellated)
  {
    this->DrawPatches();
  }
  else
  {
    this->Patterns.SetShape(primitives, this->Options.Sides);
    this->DrawInstances(GetMode(primitives));
  }
  helper.VAO->Release();
  this->Geometry.Deactivate();
  this->Colors.Deactivate();
}

void CurvePainter::DrawInstances(unsigned int mode)
{
  const GLint location = FindGroupUniform(this->Variants.GetHelper().Program);
  const int moreSegments = GetMoreRings(this->Options.Sides);
  for (const CurveSelection::Group& group : this->Geometry.GetSelection().GetGroups())
  {
    this->Patterns.GetRange(group.Segments + moreSegments);
  }
  this->Patterns.Bind();
  for (const CurveSelection::Group& group : this->Geometry.GetSelection().GetGroups())
  {
    const PatternRange& range = this->Patterns.GetRange(group.Segments + moreSegments);
    const auto [instances, copies] = CountInstances(group.Count, range.Copies);
    glUniform4i(location, group.Offset, group.Count, copies, group.Segments);
    glDrawElementsInstanced(mode, copies * range.NumberOfIndices, GL_UNSIGNED_SHORT,
      CurvePatterns::GetOffset(range), instances);
    ++this->NumberOfDrawCalls;
  }
  this->Patterns.Release();
}

void CurvePainter::DrawPatches()
{
  const GLint location = FindGroupUniform(this->Variants.GetHelper().Program);
  const int moreSegments = GetMoreRings(this->Options.Sides);
  const int around = this->Options.Sides > 2 ? this->Options.Sides + 1 : this->Options.Sides;
  glPatchParameteri(GL_PATCH_VERTICES, 1);
  for (const CurveSelection::Group& group : this->Geometry.GetSelection().GetGroups())
  {
    const int segments = std::min(group.Segments, MaximumTessellated - moreSegments);
    // Mesa's tessellator on the CPU counts the vertices of a call in 16 bits.
    const int most = IsHardwareRenderer()
      ? group.Count
      : std::max(1, 65535 / ((segments + moreSegments + 1) * around));
    glUniform4i(location, 0, 0, 0, segments);
    for (int first = 0; first < group.Count; first += most)
    {
      glDrawArrays(GL_PATCHES, group.Offset + first, std::min(most, group.Count - first));
      ++this->NumberOfDrawCalls;
    }
  }
}

int CurvePainter::GetMaximumSegments() const
{
  return this->Options.IsTessellated ? MaximumTessellated - GetMoreRings(this->Options.Sides)
                                     : std::numeric_limits<int>::max();
}

vtkIdType CurvePainter::CountDrawnSegments() const
{
  return this->Geometry.GetSelection().CountDrawnSegments(this->GetMaximumSegments());
}

vtkIdType CurvePainter::CountHiddenSegments() const
{
  return this->Geometry.GetSelection().CountHiddenSegments(this->GetMaximumSegments());
}

//------------------------------------------------------------------------------
// Shaders

void CurvePainter::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  // Control points are relative to the origin.
  const dvec3& origin = this->Geometry.GetOrigin();
  ShiftPositions(this->VBOs, this->Box->GetPoints()->GetData(), renderer,
    { origin.x, origin.y, origin.z }, { 1.0, 1.0, 1.0 });
  this->Superclass::BuildBufferObjects(renderer, actor);
}

bool CurvePainter::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Options.HasCells = this->IsSelectingCells();
  const bool needed = this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor);
  if (!this->Variants.NeedsBuild(helper, needed, this->Options.GetKey()))
  {
    return false;
  }
  if (!this->Options.IsTessellated)
  {
    this->Programs.ReleaseGraphicsResources(renderer->GetRenderWindow());
    return true;
  }
  return !this->BuildStages(helper, renderer, actor);
}

bool CurvePainter::BuildStages(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  return this->Variants.BuildWithStages(
    helper, [&](ShaderVariants::Shaders& shaders) { this->BuildShaders(shaders, renderer, actor); },
    [&](ShaderVariants::Shaders& shaders)
    {
      auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
      vtkShaderProgram* program = this->Programs.Build(
        window, relevoTessellationVS, GetCurveControlShader(this->Options), shaders);
      if (!program)
      {
        this->FailedStages = Dependencies::On(actor->GetShaderProperty()->GetShaderMTime());
        this->TessellationError = "its shaders cannot be built: " + this->Programs.GetError();
        this->Options.IsTessellated = false;
        this->Variants.SetKey(helper, this->Options.GetKey());
      }
      return program;
    });
}

void CurvePainter::PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor* actor)
{
  PrepareCurveShaders(this->Options, HasOwnFragments(actor), shaders, this->Variants.GetMissing());
}

void CurvePainter::FinishShaders(ShaderVariants::Shaders& shaders)
{
  FinishCurveShaders(this->Options, shaders, this->Variants.GetMissing());
}

void CurvePainter::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  this->Geometry.Activate(helper.Program);
  this->Colors.Activate(helper.Program);
}

//------------------------------------------------------------------------------
// Selection

void CurvePainter::AnnounceIds(vtkHardwareSelector* selector) const
{
  selector->UpdateMaximumCellId(this->Geometry.GetInput()->GetNumberOfCells());
}

//------------------------------------------------------------------------------

vtkTypeInt64 CurvePainter::GetMemorySize() const
{
  return this->Geometry.GetMemorySize() + this->Colors.GetMemorySize() +
    this->Patterns.GetMemorySize();
}

CurvePainter::Counts CurvePainter::GetCounts() const
{
  return { this->Geometry.GetSelection().GetNumberOfEvaluations(),
    this->Geometry.GetNumberOfUploads(), this->Variants.GetNumberOfBuilds() };
}

void CurvePainter::Counts::operator+=(const Counts& other)
{
  this->Selections += other.Selections;
  this->BufferBuilds += other.BufferBuilds;
  this->ShaderBuilds += other.ShaderBuilds;
}

void CurvePainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Geometry.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
  this->Patterns.ReleaseGraphicsResources();
  this->Programs.ReleaseGraphicsResources(window);
  this->ColorSource.Clear();
  this->FailedStages.Clear();
}
}
