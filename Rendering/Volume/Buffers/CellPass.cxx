// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/CellPass.h"

#include "Passes/ScreenPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace relevo
{
namespace
{
constexpr size_t CellsPerRow = 4096;
}

bool CellPass::Draw(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, size_t numberOfCells,
  const std::vector<RenderTarget::Format>& formats)
{
  const size_t rows = (numberOfCells + CellsPerRow - 1) / CellsPerRow;
  if (rows > CellsPerRow ||
    !this->Target.Begin(window, CellsPerRow, static_cast<int>(rows), formats))
  {
    return false;
  }
  this->NumberOfCells = numberOfCells;
  program->SetUniformi("cellsPerRow", static_cast<int>(CellsPerRow));
  program->SetUniformi("numberOfCells", static_cast<int>(numberOfCells));
  this->Target.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
  this->Target.End();
  return true;
}

void CellPass::Activate(vtkShaderProgram* program, const std::string& sampler, size_t texture)
{
  this->Target.Activate(program, sampler, texture);
  program->SetUniformi("cellsPerRow", static_cast<int>(CellsPerRow));
}

void CellPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Target.ReleaseGraphicsResources(window);
}
}
