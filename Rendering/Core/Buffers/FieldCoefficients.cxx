// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/FieldCoefficients.h"

#include "Buffers/DirectColors.h"
#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <limits>
#include <vector>

namespace relevo
{
bool FieldCoefficients::Upload(vtkOpenGLRenderWindow* window, const Dependencies& source,
  const FieldScalars& scalars, vtkDataArray* coefficients, const MakeNumbers& makeNumbers)
{
  const int type = scalars.Array->GetDataType();
  this->Coloring = FieldColoring::NONE;
  if (scalars.AreColors)
  {
    this->ReleaseGraphicsResources(window);
    const std::vector<float> colors = GetDirectColors(coefficients, type);
    if (colors.empty())
    {
      return true; // VTK's colours of the corners are used
    }
    this->Coloring = FieldColoring::COLORS;
    ++this->NumberOfColorUploads;
    return this->Colors.Upload(window, colors, 4);
  }
  this->Colors.ReleaseGraphicsResources(window);
  Dependencies made = source;
  made.Add(scalars.NoDataMagnitude);
  if (this->Source.Update(made) || !this->Made)
  {
    this->Made = makeNumbers();
  }
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!this->Numbers.Upload(
        window, this->Made, scalars.Table, scalars.Component, scalars.ByTexture, none, type))
  {
    return false;
  }
  const ScalarKind kind = this->Numbers.GetKind();
  this->Coloring = kind == BY_VALUE
    ? FieldColoring::TABLE
    : (kind == BY_TEXTURE ? FieldColoring::TEXTURE : FieldColoring::NONE);
  return true;
}

bool FieldCoefficients::IsNumber() const
{
  const bool hasTable =
    this->Coloring == FieldColoring::TABLE || this->Coloring == FieldColoring::TEXTURE;
  return hasTable && this->Numbers.IsNumber();
}

void FieldCoefficients::Activate(vtkShaderProgram* program)
{
  if (this->Coloring == FieldColoring::TABLE || this->Coloring == FieldColoring::TEXTURE)
  {
    this->Numbers.Activate(program);
  }
  else if (this->Coloring == FieldColoring::COLORS)
  {
    this->Colors.Activate(program, "relevoFieldColors");
  }
}

void FieldCoefficients::Deactivate()
{
  this->Numbers.Deactivate();
  this->Colors.Deactivate();
}

vtkTypeInt64 FieldCoefficients::GetMemorySize() const
{
  return this->Numbers.GetMemorySize() + this->Colors.GetMemorySize();
}

void FieldCoefficients::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Coloring = FieldColoring::NONE;
  this->Source.Clear();
  this->Made = nullptr;
  this->Numbers.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
}
}
