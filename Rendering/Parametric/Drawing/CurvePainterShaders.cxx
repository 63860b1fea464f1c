// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Shaders of curves: when they are written, from what, and what they are given.
#include "Drawing/CurvePainter.h"

#include "OpenGL/PositionShift.h"
#include "OpenGL/ShaderUniforms.h"

#include "Actors/ShaderVariantKey.h"
#include "Compatibility/VTKCompatibility.h"
#include "relevoTessellationVS.h"
#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

namespace relevo
{
void CurvePainter::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  // Control points are relative to the origin.
  ShiftPositions(this->VBOs, this->Box->GetPoints()->GetData(), renderer,
    { this->Origin.x, this->Origin.y, this->Origin.z }, { 1.0, 1.0, 1.0 });
  this->Superclass::BuildBufferObjects(renderer, actor);
}

bool CurvePainter::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Options.HasCells = this->LastSelectionState == vtkHardwareSelector::CELL_ID_LOW24 ||
    this->LastSelectionState == vtkHardwareSelector::CELL_ID_HIGH24;
  const bool needed = this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor);
  const bool changed = this->ShaderKey.Update(this->Options.GetKey());
  if (!needed && !changed)
  {
    return false;
  }
  // One of other sources must not draw in place of one that cannot be built.
  helper.Program = AsksLastProgram ? this->NoProgram.Get() : nullptr;
  if (!this->Options.IsTessellated)
  {
    this->Programs.ReleaseGraphicsResources(renderer->GetRenderWindow());
    return true;
  }
  return !this->BuildStages(helper, renderer, actor);
}

bool CurvePainter::BuildStages(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  vtkNew<vtkShader> stages[3];
  const vtkShader::Type types[3] = { vtkShader::Vertex, vtkShader::Geometry, vtkShader::Fragment };
  std::map<vtkShader::Type, vtkShader*> shaders;
  for (int i = 0; i < 3; ++i)
  {
    stages[i]->SetType(types[i]);
    shaders[types[i]] = stages[i];
  }
  this->BuildShaders(shaders, renderer, actor);
  if (!this->ShaderProblem.empty())
  {
    return false; // said by now; VTK's shader cache has a program for them
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkShaderProgram* program = this->Programs.Build(
    window, relevoTessellationVS, GetCurveControlShader(this->Options), shaders);
  if (!program)
  {
    this->FailedStages = Dependencies::On(actor->GetShaderProperty()->GetShaderMTime());
    this->TessellationProblem = "its shaders cannot be built: " + this->Programs.GetError();
    this->Options.IsTessellated = false;
    this->ShaderKey = this->Options.GetKey();
    return false;
  }
  helper.Program = program;
  helper.VAO->ReleaseGraphicsResources(); // of the attributes of another program
  helper.ShaderSourceTime.Modified();
  return true;
}

void CurvePainter::BuildShaders(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Missing.clear();
  this->Superclass::BuildShaders(shaders, renderer, actor);
  ++this->NumberOfShaderBuilds;
  this->ShaderProblem = this->Missing.empty() ? "" : DescribeMissing(this->Missing);
  if (!this->Missing.empty())
  {
    DrawNothing(shaders);
  }
}

void CurvePainter::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  PrepareCurveShaders(this->Options, HasOwnFragments(actor), shaders, this->Missing);
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  FinishCurveShaders(this->Options, shaders, this->Missing);
}

void CurvePainter::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  vtkShaderProgram* program = helper.Program;
  this->Buffers.Activate(program);
  this->Colors.Activate(program);
  if (program->IsUniformUsed("relevoEye"))
  {
    SetVector(program, "relevoEye", this->Eye);
  }
  if (program->IsUniformUsed("relevoRadius"))
  {
    program->SetUniformf("relevoRadius", static_cast<float>(this->Radii.front()));
  }
}
}
