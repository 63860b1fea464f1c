// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Which method draws, and its draw calls.
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "Mathematics/SameNumber.h"
#include "OpenGL/RelevoOpenGL.h"

#include "Evaluation/PatternSelection.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRenderer.h"

namespace
{
// Private code numbers methods and colour modes as the mapper does.
using Mapper = vtkAdaptiveRefinementMapper;
using Method = relevo::RefinementMethod;
static_assert(relevo::HaveSameNumber(Mapper::METHOD_ARKFPI, Method::ARKFPI), "ARKFPI");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_ARK, Method::ARK), "ARK");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_DMR, Method::DMR), "DMR");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_SUAPT, Method::SUAPT), "SUAPT");
static_assert(
  relevo::HaveSameNumber(Mapper::METHOD_HARDWARE_TESSELLATION, Method::HARDWARE_TESSELLATION),
  "tessellation");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_UNIFORM, Method::UNIFORM), "uniform");
static_assert(
  relevo::HaveSameNumber(Mapper::COLOR_BY_SCALARS, relevo::COLOR_BY_SCALARS), "scalars");
static_assert(relevo::HaveSameNumber(Mapper::COLOR_BY_LEVEL, relevo::COLOR_BY_LEVEL), "level");
static_assert(
  relevo::HaveSameNumber(Mapper::COLOR_BY_PATTERN, relevo::COLOR_BY_PATTERN), "pattern");
static_assert(relevo::HaveSameNumber(Mapper::COLOR_BY_METRIC, relevo::COLOR_BY_METRIC), "metric");

relevo::RefinementMethod::Primitives GetPrimitives(int mode, bool pointPicking)
{
  using Primitives = relevo::RefinementMethod::Primitives;
  return mode == GL_TRIANGLES ? Primitives::TRIANGLES
    : mode == GL_LINES        ? Primitives::LINES
    : pointPicking            ? Primitives::CORNERS
                              : Primitives::POINTS;
}
}

relevo::RefinementMethod& vtkAdaptiveRefinementMapper::vtkInternals::GetMethod()
{
  std::unique_ptr<relevo::RefinementMethod>& method = this->Methods[this->MethodInUse];
  if (!method)
  {
    method = relevo::RefinementMethod::New(this->MethodInUse);
  }
  return *method;
}

relevo::RefinementDrawing vtkAdaptiveRefinementMapper::vtkInternals::GetDrawing(
  vtkAdaptiveRefinement* recipe)
{
  const int slot = this->State.GetSelectionSlot();
  return { this->GetWindow(), &this->State.GetSelection().GetMesh(), &this->State.GetSelection(),
    slot, this->OnGPU ? &this->Compute.GetView(slot) : nullptr,
    recipe ? recipe->GetPatternTable()->GetLibrary().get() : nullptr, this->HasLines,
    &this->Patterns, &this->Instances };
}

int vtkAdaptiveRefinementMapper::GetMethodInUse()
{
  int method = this->Internals->MethodInUse;
  this->ForEachBlock(
    [&method](vtkAdaptiveRefinementMapper* block) { method = block->GetMethodInUse(); });
  return method;
}

void vtkAdaptiveRefinementMapper::ChooseMethod(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const int representation = act->GetProperty()->GetRepresentation();
  data.HasLines = representation == VTK_WIREFRAME;
  data.MethodInUse = this->Method;
  const relevo::RefinementMethod& method = data.GetMethod();
  std::string problem = method.GetMissing();
  if (!problem.empty())
  {
    problem = "it needs " + problem + ", which this OpenGL context does not have";
  }
  else
  {
    problem = method.GetObstacle(*relevo::GetPatternFamily(this->Refinement, this->GetInput()));
  }
  if (problem != data.MethodProblem)
  {
    data.MethodProblem = problem;
    if (!problem.empty())
    {
      this->ReportMethodUnavailable(problem);
    }
  }
  if (!data.Failure.IsEmpty() &&
    data.Failure != vtkInternals::GetShaderSources(this->Refinement, act))
  {
    data.Failure.Clear();
  }
  using Primitives = relevo::RefinementMethod::Primitives;
  const Primitives faces =
    GetPrimitives(this->GetOpenGLMode(representation, data.Faces.PrimitiveType), false);
  const bool hasVertices = vtkInternals::AreVerticesDrawn(act->GetProperty(), ren->GetSelector());
  if (!problem.empty() || !data.Failure.IsEmpty() ||
    !method.CanDraw(this->PointPicking ? Primitives::CORNERS : faces) ||
    (hasVertices && !method.CanDraw(Primitives::POINTS)))
  {
    data.MethodInUse = METHOD_ARKFPI;
  }
  // What other methods have on the GPU is of no use.
  for (auto& other : data.Methods)
  {
    if (other.first != this->Method && other.first != data.MethodInUse)
    {
      data.ForgetPrograms(other.first);
      if (other.first != METHOD_ARKFPI) // which stands in for all
      {
        data.FailedUploads.erase(other.first);
      }
      other.second->ReleaseGraphicsResources(ren->GetRenderWindow());
    }
  }
}

void vtkAdaptiveRefinementMapper::ReportMethodUnavailable(const std::string& problem)
{
  vtkErrorMacro("The method " << relevo::RefinementMethod::GetName(this->Method)
                              << " cannot be used: " << problem
                              << ". The method ARKFPI is used instead.");
}

bool vtkAdaptiveRefinementMapper::UploadMethod()
{
  vtkInternals& data = *this->Internals;
  const relevo::RefinementDrawing drawing = data.GetDrawing(this->Refinement);
  const relevo::Dependencies sources =
    relevo::Dependencies::On(drawing.Selection->GetGroupsTime(), data.OnGPU);
  std::map<int, relevo::Dependencies>& failures = data.FailedUploads[data.MethodInUse];
  const auto failure = failures.find(drawing.Slot);
  if (failure == failures.end() || failure->second != sources)
  {
    if (data.GetMethod().Upload(drawing))
    {
      failures.erase(drawing.Slot);
      return true;
    }
    const bool isSaid = !failures.empty();
    failures[drawing.Slot] = sources;
    if (!isSaid && data.MethodInUse == METHOD_ARKFPI)
    {
      vtkErrorMacro("Cannot draw the input: " << data.GetMethod().GetError() << ".");
    }
    else if (!isSaid)
    {
      this->ReportMethodUnavailable(data.GetMethod().GetError());
    }
  }
  if (data.MethodInUse == METHOD_ARKFPI)
  {
    return false;
  }
  data.MethodInUse = METHOD_ARKFPI;
  return this->UploadMethod();
}

void vtkAdaptiveRefinementMapper::FallBackToDefaultMethod(vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.Failure = vtkInternals::GetShaderSources(this->Refinement, act);
  this->ReportMethodUnavailable("its shaders cannot be built: " + data.GetMethod().GetError());
  data.MethodInUse = METHOD_ARKFPI;
  data.Drawable = this->UploadMethod();
  this->UpdateFaceColors();
}

void vtkAdaptiveRefinementMapper::DrawFaces(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow())->GetState();
  int mode = this->GetOpenGLMode(act->GetProperty()->GetRepresentation(), cellBO.PrimitiveType);
  if (this->PointPicking)
  {
    state->vtkglPointSize(this->GetPointPickingPrimitiveSize(cellBO.PrimitiveType));
    mode = GL_POINTS;
  }
  this->UpdateRefiningShaders(cellBO, ren, act);
  if (!cellBO.Program || !data.Drawable || data.Programs[&cellBO].DrawsNothing)
  {
    return;
  }
  if (mode == GL_LINES && !this->HaveWideLines(ren, act))
  {
    state->vtkglLineWidth(act->GetProperty()->GetLineWidth());
  }
  cellBO.VAO->Bind();
  data.NumberOfDrawCalls += data.GetMethod().Draw(
    data.GetDrawing(this->Refinement), cellBO.Program, GetPrimitives(mode, this->PointPicking));
}
