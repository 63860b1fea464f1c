// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Which method draws, and its draw calls.
#include "vtkAdaptiveRefinementMapperInternals.h"

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

static_assert(static_cast<int>(vtkAdaptiveRefinementMapper::METHOD_UNIFORM) ==
      relevo::RefinementMethod::UNIFORM &&
    static_cast<int>(vtkAdaptiveRefinementMapper::COLOR_BY_METRIC) == relevo::COLOR_BY_METRIC,
  "private code numbers methods and colour modes as the mapper does");

namespace
{
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
    problem = "Needs " + problem + ", which this OpenGL context does not have";
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
      vtkErrorMacro("The method " << relevo::RefinementMethod::GetName(this->Method)
                                  << " cannot be used: " << problem << ". ARKFPI draws.");
    }
  }
  if (data.Failure.Cause != vtkInternals::GetShaderCause(this->Refinement, act))
  {
    data.Failure = {};
  }
  using Primitives = relevo::RefinementMethod::Primitives;
  const Primitives faces =
    GetPrimitives(this->GetOpenGLMode(representation, data.Faces.PrimitiveType), false);
  const bool hasVertices = vtkInternals::AreVerticesDrawn(act->GetProperty(), ren->GetSelector());
  if (!problem.empty() || !data.Failure.Text.empty() ||
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
      other.second->ReleaseGraphicsResources(ren->GetRenderWindow());
    }
  }
}

void vtkAdaptiveRefinementMapper::GiveUpMethod(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.Failure = { "Its shaders cannot be built: " + data.GetMethod().GetError(),
    vtkInternals::GetShaderCause(this->Refinement, act) };
  vtkErrorMacro("The method " << relevo::RefinementMethod::GetName(this->Method)
                              << " cannot be used: " << data.Failure.Text << ". ARKFPI draws.");
  data.MethodInUse = METHOD_ARKFPI;
  data.Drawable =
    data.GetMethod().Upload(data.GetDrawing(this->Refinement)) && this->UpdateFaceColors(ren);
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
