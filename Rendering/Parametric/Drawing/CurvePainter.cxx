// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurvePainter.h"

#include "OpenGL/ContextFacts.h"
#include "OpenGL/RelevoOpenGL.h"

#include "Actors/ActorView.h"
#include "Curves/CurveFrames.h"
#include "Curves/CurveRadii.h"
#include "Drawing/CurveScalars.h"
#include "Evaluation/FaceCulling.h"
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <limits>

namespace relevo
{
namespace
{
// The most segments that every OpenGL's tessellator makes.
constexpr int MostTessellated = 64;

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
  this->ScalarVisibility = 0;
  this->PopulateSelectionSettings = 0; // the mapper does
  this->SetVBOShiftScaleMethod(
    static_cast<int>(vtkOpenGLVertexBufferObject::ShiftScaleMethod::MANUAL_SHIFT_SCALE));
  this->Box->SetPoints(vtkNew<vtkPoints>());
  this->SetInputData(this->Box);
}

CurvePainter::~CurvePainter() = default;

//------------------------------------------------------------------------------
// Curves

bool CurvePainter::SetCurves(vtkPointSet* input)
{
  Dependencies source;
  source.AddObject(input);
  if (!this->CurveSource.Update(source))
  {
    return false;
  }
  this->CurveInput = input;
  this->Mesh.Build(input);
  this->Selection.SetCurves(input, this->Mesh);
  this->PointBox = FiniteBox();
  for (const dvec4& point : this->Mesh.GetPoints())
  {
    this->PointBox.Add(&point.x);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = this->PointBox.GetMiddle(axis);
  }
  this->NeedsCurves = true;
  this->NeedsRadii = true;
  this->NeedsFrames = true;
  this->ColorSource.Clear();
  this->ShapeSource.Clear();
  return true;
}

std::string CurvePainter::SetShape(const Shape& shape)
{
  const Dependencies source =
    Dependencies::On(shape.Sides > 1, shape.Radius, shape.RadiusArrayName);
  this->CurveShape = shape;
  if (!this->ShapeSource.Update(source))
  {
    return this->RadiusProblem;
  }
  this->RadiusProblem.clear();
  this->Radii.assign(1, shape.Sides > 1 ? shape.Radius : 0.0);
  if (shape.Sides > 1 && !shape.RadiusArrayName.empty())
  {
    if (vtkDataArray* radii =
          FindCurveRadii(this->CurveInput, shape.RadiusArrayName, this->RadiusProblem))
    {
      this->Radii = this->Mesh.ComputeCoefficients(radii);
    }
  }
  this->NeedsRadii = true;
  this->Selection.SetReaches(this->Radii, this->Origin);
  this->UpdateBox();
  return this->RadiusProblem;
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
    vtkNew<vtkFloatArray> normals; // VTK lights lines that have some
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(2);
    normals->Fill(0.0);
    this->Box->GetPointData()->SetNormals(normals);
  }
}

void CurvePainter::GetCurveBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  if (this->Mesh.GetNumberOfCurves() > 0)
  {
    const double reach = this->Radii.empty()
      ? 0.0
      : std::abs(*std::max_element(this->Radii.begin(), this->Radii.end(),
          [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = this->PointBox.Low[axis] - reach;
      bounds[2 * axis + 1] = this->PointBox.High[axis] + reach;
    }
  }
}

//------------------------------------------------------------------------------
// What a view shows

std::string CurvePainter::Prepare(vtkRenderer* renderer, vtkActor* actor, const Settings& settings)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->NumberOfDrawCalls = 0;
  vtkProperty* property = actor->GetProperty();
  const CullingView culling(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(),
    actor->GetMatrix(), &this->Origin.x,
    GetViewMargins(renderer, std::max(property->GetLineWidth(), property->GetPointSize())));
  this->Eye = dvec4(culling.Eye[0], culling.Eye[1], culling.Eye[2], culling.Parallel ? 0.0 : 1.0);
  std::string error;
  if (!this->Selection.Update(settings.Recipe, MakeActorView(renderer, actor),
        settings.IsCulled && !MovesVertices(actor) ? &culling : nullptr, error))
  {
    return error;
  }
  const bool isSelecting = renderer->GetSelector() != nullptr;
  if (!this->Upload(window, isSelecting))
  {
    return "Cannot draw the input: " + BufferTexture::GetTooLarge() + ".";
  }
  this->UpdateColors(window, settings.Scalars);
  this->Helper.PrimitiveType = this->CurveShape.Sides == 1 ? PrimitiveLines : PrimitiveTris;
  this->Options.Sides = this->CurveShape.Sides;
  this->Options.Degree = this->Buffers.GetDegree();
  this->Options.IsRational = this->Buffers.IsRational();
  this->Options.HasRadii = this->CurveShape.Sides > 1 && this->Buffers.HasRadii();
  this->Options.Coloring = this->Colors.GetColoring();
  this->ChooseMethod(actor, settings.IsTessellated);
  return "";
}

void CurvePainter::UpdateColors(vtkOpenGLRenderWindow* window, vtkMapper* scalars)
{
  Dependencies source = GetScalarSettings(scalars);
  if (this->ColorSource.Update(source))
  {
    this->ColorProblem = UploadScalars(window, scalars, this->CurveInput, this->Mesh, this->Colors);
    this->ColorSource = GetScalarSettings(scalars); // mapping sets the table's range
    if (!this->ColorProblem.empty())
    {
      this->Colors.Clear(window);
    }
  }
}

bool CurvePainter::Upload(vtkOpenGLRenderWindow* window, bool withCells)
{
  if (this->NeedsCurves)
  {
    ++this->NumberOfBufferBuilds;
    if (!this->Buffers.Upload(window, this->Mesh, this->Origin))
    {
      return false;
    }
    this->NeedsCurves = false;
  }
  const bool hasSides = this->CurveShape.Sides > 1;
  if (hasSides && this->NeedsRadii)
  {
    ++this->NumberOfBufferBuilds;
    if (!this->Buffers.UploadRadii(
          window, this->Radii.size() > 1 ? this->Radii : std::vector<double>()))
    {
      return false;
    }
    this->NeedsRadii = false;
  }
  if (hasSides && this->NeedsFrames)
  {
    ++this->NumberOfBufferBuilds;
    CurveFrames frames;
    frames.Build(this->Mesh);
    if (!this->Buffers.UploadFrames(window, frames))
    {
      return false;
    }
    this->NeedsFrames = false;
  }
  return (!withCells || this->Buffers.UploadCells(window, this->Mesh)) &&
    this->Instances.Upload(
      window, 0, this->Selection.GetMembers(), this->Selection.GetGroupsTime());
}

void CurvePainter::ChooseMethod(vtkActor* actor, bool isTessellated)
{
  const int sides = this->Options.Sides;
  this->Options.IsTessellated = false;
  this->TessellationProblem.clear();
  if (!isTessellated || GetPrimitives(sides, actor) != GetPlainPrimitives(sides))
  {
    return;
  }
  if (!TessellationPrograms::AreSupported())
  {
    this->TessellationProblem = "it needs OpenGL 4.0, which this OpenGL context does not have";
    return;
  }
  this->Options.IsTessellated = this->FailedStages.IsEmpty() ||
    this->FailedStages != Dependencies::On(actor->GetShaderProperty()->GetShaderMTime());
}

//------------------------------------------------------------------------------
// Drawing

void CurvePainter::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Selection.GetGroups().empty() || this->PointPicking)
  {
    return;
  }
  Dependencies sources = this->Options.GetKey();
  sources.Add(actor->GetShaderProperty()->GetShaderMTime());
  sources.Add(this->GetMTime());
  if (!this->Helper.Program && sources == this->FailedSources)
  {
    return; // said by now
  }
  this->UpdateShaders(this->Helper, renderer, actor);
  if (!this->Helper.Program)
  {
    this->FailedSources = sources;
    this->ShaderProblem = "The shaders could not be built; OpenGL's own message says why. The "
                          "actor's vtkShaderProperty is part of them.";
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const CurvePatterns::Primitives primitives = GetPrimitives(this->Options.Sides, actor);
  if (primitives == CurvePatterns::LINES && !this->HaveWideLines(renderer, actor))
  {
    window->GetState()->vtkglLineWidth(actor->GetProperty()->GetLineWidth());
  }
  this->Helper.VAO->Bind(); // VTK releases it when the program is another
  this->Instances.Activate(this->Helper.Program);
  if (this->Options.IsTessellated)
  {
    this->DrawPatches();
  }
  else
  {
    this->Patterns.SetShape(primitives, this->Options.Sides);
    this->DrawInstances(GetMode(primitives));
  }
  this->Helper.VAO->Release();
  this->Instances.Deactivate();
  this->Buffers.Deactivate();
  this->Colors.Deactivate();
}

void CurvePainter::DrawInstances(unsigned int mode)
{
  const GLint location =
    glGetUniformLocation(static_cast<GLuint>(this->Helper.Program->GetHandle()), "relevoGroup");
  const int moreSegments = GetMoreRings(this->Options.Sides);
  for (const CurveSelection::Group& group : this->Selection.GetGroups())
  {
    this->Patterns.GetRange(group.Segments + moreSegments);
  }
  this->Patterns.Bind();
  for (const CurveSelection::Group& group : this->Selection.GetGroups())
  {
    // As many instances as it takes, each of as many copies as it takes.
    const CurvePatterns::Range& range = this->Patterns.GetRange(group.Segments + moreSegments);
    const int instances = (group.Count + range.Copies - 1) / range.Copies;
    const int copies = (group.Count + instances - 1) / instances;
    glUniform4i(location, group.Offset, group.Count, copies, group.Segments);
    glDrawElementsInstanced(mode, copies * range.NumberOfIndices, GL_UNSIGNED_SHORT,
      reinterpret_cast<const void*>(static_cast<size_t>(range.FirstIndex) * sizeof(unsigned short)),
      instances);
    ++this->NumberOfDrawCalls;
  }
  this->Patterns.Release();
}

void CurvePainter::DrawPatches()
{
  const GLint location =
    glGetUniformLocation(static_cast<GLuint>(this->Helper.Program->GetHandle()), "relevoGroup");
  const int moreSegments = GetMoreRings(this->Options.Sides);
  const int around = this->Options.Sides > 2 ? this->Options.Sides + 1 : this->Options.Sides;
  glPatchParameteri(GL_PATCH_VERTICES, 1);
  for (const CurveSelection::Group& group : this->Selection.GetGroups())
  {
    const int segments = std::min(group.Segments, MostTessellated - moreSegments);
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

int CurvePainter::GetMostSegments() const
{
  return this->Options.IsTessellated ? MostTessellated - GetMoreRings(this->Options.Sides)
                                     : std::numeric_limits<int>::max();
}

vtkIdType CurvePainter::CountDrawnSegments() const
{
  return this->Selection.CountDrawnSegments(this->GetMostSegments());
}

vtkIdType CurvePainter::CountHiddenSegments() const
{
  return this->Selection.CountHiddenSegments(this->GetMostSegments());
}

//------------------------------------------------------------------------------
// Selection

void CurvePainter::AnnounceIds(vtkHardwareSelector* selector) const
{
  selector->UpdateMaximumCellId(this->CurveInput->GetNumberOfCells());
}

// What is drawn are the input's ids.
void CurvePainter::ProcessSelectorPixelBuffers(
  vtkHardwareSelector*, std::vector<unsigned int>&, vtkProp*)
{
}

//------------------------------------------------------------------------------

vtkTypeInt64 CurvePainter::GetMemorySize() const
{
  return this->Buffers.GetMemorySize() + this->Colors.GetMemorySize() +
    this->Patterns.GetMemorySize() + this->Instances.GetMemorySize();
}

void CurvePainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Buffers.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
  this->Patterns.ReleaseGraphicsResources();
  this->Instances.ReleaseGraphicsResources(window);
  this->Programs.ReleaseGraphicsResources(window);
  this->Helper.ReleaseGraphicsResources(window);
  this->NeedsCurves = true;
  this->NeedsRadii = true;
  this->NeedsFrames = true;
  this->ColorSource.Clear();
  this->FailedStages.Clear();
  this->FailedSources.Clear();
}
}
