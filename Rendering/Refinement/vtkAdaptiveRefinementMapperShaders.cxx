// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Shaders of refined faces: when they are written, from what, and what they are given.
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Compatibility/VTKCompatibility.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkHardwareSelector.h"
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

vtkAdaptiveRefinementMapper::vtkInternals::ProgramState&
vtkAdaptiveRefinementMapper::vtkInternals::UpdateShaderOptions(
  vtkAdaptiveRefinementMapper* mapper, const vtkOpenGLHelper* cellBO)
{
  vtkAdaptiveRefinement* recipe = mapper->Refinement;
  ProgramState& program = this->Programs[cellBO];
  relevo::RefinementShaderOptions& options = program.Options;
  options = {};
  this->Buffers.FillOptions(this->State.GetMesh(), options);
  vtkRefinementSurface* surface = recipe->GetSurface();
  options.SurfaceSource = (surface ? surface : this->Linear.Get())->GetShaderSource();
  options.HasTables = surface && surface->HasTables();
  options.HasSurfaceDirections = surface && surface->HasDirections();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  this->GetMethod().FillOptions(this->GetDrawing(recipe), options);
  options.HasDisplacement = displacement != nullptr;
  options.AlongNormal = displacement && displacement->IsAlongNormal();
  options.ColorMode = cellBO != &this->Vertices ? mapper->RefinementColorMode : COLOR_BY_SCALARS;
  options.Scalars = options.ColorMode == COLOR_BY_SCALARS ? this->Colors.GetKind() : relevo::BY_VTK;
  options.HasNoData = options.Scalars != relevo::BY_VTK && this->Colors.HasNoData();
  options.Extension.HasNormals = options.HasNormals;
  mapper->ExtendShaders(cellBO, options.Extension);
  if (options.Extension.HasOwnColors)
  {
    options.Scalars = relevo::BY_VTK; // none are needed of vertices
    options.HasNoData = false;
  }
  program.HasNewKey = program.Key.Update(options.GetKey());
  return program;
}

void vtkAdaptiveRefinementMapper::UpdateRefiningShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkInternals::ProgramState& program = data.UpdateShaderOptions(this, &cellBO);
  const bool changed = program.Times.Update(
    relevo::Dependencies::On(act->GetShaderProperty()->GetShaderMTime(), this->GetBuildMTime()));
  if (program.HasFailed && !program.HasNewKey && !changed)
  {
    return; // there is no program
  }
  this->UpdateShaders(cellBO, ren, act);
  program.HasFailed = !cellBO.Program;
  if (program.HasFailed)
  {
    vtkErrorMacro("The shaders could not be built; OpenGL's own message says why. A "
                  "vtkProceduralSurface's ShaderFunction and the actor's vtkShaderProperty are "
                  "part of them.");
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
    needed = needed || program.HasNewKey;
    if (needed)
    {
      // One of other sources must not draw in place of one that cannot be built.
      cellBO.Program = relevo::AsksLastProgram ? data.NoProgram.Get() : nullptr;
      program.Method = -1;
      if (data.GetMethod().HasStages() && this->BuildStages(cellBO, ren, act))
      {
        return false; // VTK's shader cache binds it like any other
      }
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
    this->FallBackToDefaultMethod(act);
    data.UpdateShaderOptions(this, &cellBO);
    return false;
  }
  cellBO.Program = program;
  cellBO.VAO->ReleaseGraphicsResources(); // of the attributes of another program
  cellBO.ShaderSourceTime.Modified();
  data.Programs[&cellBO].Method = data.MethodInUse;
  return true;
}

relevo::Dependencies vtkAdaptiveRefinementMapper::vtkInternals::GetShaderSources(
  vtkAdaptiveRefinement* recipe, vtkActor* act)
{
  vtkRefinementSurface* surface = recipe->GetSurface();
  return relevo::Dependencies::On(act->GetShaderProperty()->GetShaderMTime(),
    surface ? surface->GetShaderSource() : std::string());
}

void vtkAdaptiveRefinementMapper::ExtendShaders(const vtkOpenGLHelper*, relevo::ShaderExtension&)
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
  vtkInternals::ProgramState& program = this->Internals->Programs[this->LastBoundBO];
  const relevo::RefinementShaderOptions& options = program.Options;
  relevo::MarkColors(options, purpose, shaders, this->MissingAnchors);
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  ++this->Internals->NumberOfShaderBuilds;
  program.Attributes = relevo::RefineShaders(options, purpose, shaders, this->MissingAnchors);
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
