// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Shaders of refined faces: when they are written, from what, and what they are given.
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkHardwareSelector.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkProperty.h"
#include "vtkRefinementSurface.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>

vtkOpenGLHelper* vtkAdaptiveRefinementMapper::AddFaceHelper()
{
  vtkInternals& data = *this->Internals;
  data.MoreFaces.emplace_back(new vtkOpenGLHelper);
  data.Helpers.push_back(data.MoreFaces.back().get());
  data.Helpers.back()->PrimitiveType = PrimitiveTris;
  return data.Helpers.back();
}

bool vtkAdaptiveRefinementMapper::IsFaceHelper(const vtkOpenGLHelper* helper) const
{
  const auto& helpers = this->Internals->Helpers;
  return std::find(helpers.begin(), helpers.end(), helper) != helpers.end();
}

bool vtkAdaptiveRefinementMapper::IsDrawable() const
{
  return this->Internals->Drawable;
}

relevo::RefinementShaderOptions vtkAdaptiveRefinementMapper::vtkInternals::GetShaderOptions(
  vtkAdaptiveRefinementMapper* mapper, const vtkOpenGLHelper* cellBO)
{
  vtkAdaptiveRefinement* recipe = mapper->Refinement;
  relevo::RefinementShaderOptions options;
  this->Buffers.Describe(this->State.GetMesh(), options);
  vtkNew<vtkLinearSurface> linear;
  vtkRefinementSurface* surface = recipe->GetSurface();
  options.SurfaceSource = (surface ? surface : linear.Get())->GetShaderSource();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  this->GetMethod().Describe(this->GetDrawing(recipe), options);
  options.HasDisplacement = displacement != nullptr;
  options.AlongNormal = displacement && displacement->IsAlongNormal();
  options.ColorMode = cellBO != &this->Vertices ? mapper->RefinementColorMode : COLOR_BY_SCALARS;
  options.Scalars = options.ColorMode == COLOR_BY_SCALARS ? this->Colors.GetKind() : relevo::BY_VTK;
  options.HasNoData = options.Scalars != relevo::BY_VTK && this->Colors.HasNoData();
  mapper->ExtendShaders(cellBO, options);
  return options;
}

void vtkAdaptiveRefinementMapper::UpdateRefiningShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const auto getSources = [&]
  {
    return relevo::Dependencies::On(
      data.GetShaderOptions(this, &cellBO).GetKey(), act->GetShaderProperty()->GetShaderMTime());
  };
  if (data.Programs[&cellBO].FailedSources == getSources())
  {
    return;
  }
  if (!cellBO.Program)
  {
    // VTK asks the last program for its time when it cannot build the next.
    cellBO.Program = data.NoProgram;
  }
  this->UpdateShaders(cellBO, ren, act);
  if (cellBO.Program == data.NoProgram)
  {
    cellBO.Program = nullptr;
  }
  if (!cellBO.Program)
  {
    // Said once, until something changes; the method may have been given up meanwhile.
    data.Programs[&cellBO].FailedSources = getSources();
    vtkErrorMacro("The shaders could not be built; OpenGL's own message says why. A "
                  "vtkProceduralSurface's ShaderFunction is part of them.");
  }
  else
  {
    data.Programs[&cellBO].FailedSources.Clear();
  }
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  if (this->IsFaceHelper(&cellBO))
  {
    vtkInternals& data = *this->Internals;
    vtkInternals::ProgramState& program = data.Programs[&cellBO];
    const std::string key = data.GetShaderOptions(this, &cellBO).GetKey();
    needed = needed || key != program.ShaderKey || cellBO.Program == data.NoProgram;
    program.ShaderKey = key;
    if (needed)
    {
      program.Method = -1;
      if (data.GetMethod().HasStages() && this->BuildStages(cellBO, ren, act))
      {
        return false; // VTK's shader cache binds it like any other
      }
      program.ShaderKey = data.GetShaderOptions(this, &cellBO).GetKey();
    }
  }
  return needed;
}

bool vtkAdaptiveRefinementMapper::BuildStages(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkNew<vtkShader> stages[3];
  const vtkShader::Type types[3] = { vtkShader::Vertex, vtkShader::Geometry, vtkShader::Fragment };
  std::map<vtkShader::Type, vtkShader*> shaders;
  for (int i = 0; i < 3; ++i)
  {
    stages[i]->SetType(types[i]);
    shaders[types[i]] = stages[i];
  }
  this->BuildShaders(shaders, ren, act);
  if (data.Programs[&cellBO].DrawsNothing)
  {
    return false; // said by now; VTK's shader cache has a program for them
  }
  vtkShaderProgram* program =
    data.GetMethod().BuildProgram(data.GetDrawing(this->Refinement), shaders);
  if (!program)
  {
    this->GiveUpMethod(ren, act);
    return false;
  }
  cellBO.Program = program;
  cellBO.VAO->ReleaseGraphicsResources(); // of the attributes of another program
  cellBO.ShaderSourceTime.Modified();
  data.Programs[&cellBO].Method = data.MethodInUse;
  return true;
}

std::string vtkAdaptiveRefinementMapper::vtkInternals::GetShaderCause(
  vtkAdaptiveRefinement* recipe, vtkActor* act)
{
  vtkRefinementSurface* surface = recipe->GetSurface();
  return std::to_string(act->GetShaderProperty()->GetShaderMTime()) +
    (surface ? surface->GetShaderSource() : "");
}

void vtkAdaptiveRefinementMapper::ExtendShaders(
  const vtkOpenGLHelper*, relevo::RefinementShaderOptions&)
{
}

void vtkAdaptiveRefinementMapper::BuildShaders(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  this->MissingAnchors.clear();
  this->Superclass::BuildShaders(shaders, ren, act);
  const std::string problem =
    this->MissingAnchors.empty() ? "" : relevo::DescribeMissing(this->MissingAnchors);
  if (!problem.empty())
  {
    relevo::DrawNothing(shaders);
  }
  data.Programs[this->LastBoundBO].DrawsNothing = !problem.empty();
  data.LacksIds = ren->GetSelector() && (data.LacksIds || !problem.empty());
  if (problem != data.ShaderProblem)
  {
    data.ShaderProblem = problem;
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem);
    }
  }
}

void vtkAdaptiveRefinementMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!this->IsFaceHelper(this->LastBoundBO))
  {
    this->Superclass::ReplaceShaderValues(shaders, ren, act);
    return;
  }
  const int mode =
    this->GetOpenGLMode(act->GetProperty()->GetRepresentation(), this->LastBoundBO->PrimitiveType);
  relevo::ShaderPurpose purpose;
  purpose.HasLines = mode == GL_LINES && !this->PointPicking;
  purpose.HasEdges =
    this->DrawingEdges(ren, act) && !act->GetShaderProperty()->HasGeometryShaderCode();
  purpose.HasPointIds = this->LastSelectionState == vtkHardwareSelector::POINT_ID_LOW24 ||
    this->LastSelectionState == vtkHardwareSelector::POINT_ID_HIGH24;
  purpose.HasCellIds = this->LastSelectionState == vtkHardwareSelector::CELL_ID_LOW24 ||
    this->LastSelectionState == vtkHardwareSelector::CELL_ID_HIGH24;
  purpose.HasOwnFragments = relevo::HasOwnFragments(act);
  const relevo::RefinementShaderOptions options =
    this->Internals->GetShaderOptions(this, this->LastBoundBO);
  relevo::MarkColors(options, purpose, shaders, this->MissingAnchors);
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  ++this->Internals->NumberOfShaderBuilds;
  this->Internals->Programs[this->LastBoundBO].Attributes =
    relevo::RefineShaders(options, purpose, shaders, this->MissingAnchors);
}

void vtkAdaptiveRefinementMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  if (!this->IsFaceHelper(&cellBO))
  {
    return;
  }
  vtkInternals& data = *this->Internals;
  vtkInternals::ProgramState& program = data.Programs[&cellBO];
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  // Another actor may have had VTK take buffers away and bring them back.
  data.Buffers.AliasAttributes(window, this->VBOs, program.Attributes);
  cellBO.AttributeUpdateTime.Modified();
  data.Buffers.Activate(cellBO.Program);
  data.Colors.Activate(cellBO.Program);
  data.FaceColors.Activate(cellBO.Program);
  data.Buffers.SetUniforms(cellBO.Program, this->Refinement);
}
