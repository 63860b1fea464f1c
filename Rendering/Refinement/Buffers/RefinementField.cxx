// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementField.h"

#include "Arrays/NoDataTuples.h"
#include "Buffers/DirectColors.h"
#include "Surfaces/SurfaceFieldShading.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <limits>
#include <vector>

namespace relevo
{
namespace
{
// Values without data become NaN, which has the table's colour for NaN between them, too.
vtkSmartPointer<vtkDataArray> WithoutNoData(vtkDataArray* values, double noDataMagnitude)
{
  const NoDataTuples noData(values, noDataMagnitude);
  if (noData.IsEmpty())
  {
    return values;
  }
  auto result = vtkSmartPointer<vtkDoubleArray>::New();
  result->DeepCopy(values);
  const std::vector<double> nothing(
    static_cast<size_t>(values->GetNumberOfComponents()), vtkMath::Nan());
  for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
  {
    if (noData.GetMarks()[static_cast<size_t>(i)] != 0)
    {
      result->SetTuple(i, nothing.data());
    }
  }
  return result;
}
}

bool RefinementField::Upload(vtkOpenGLRenderWindow* window, const Source& source)
{
  this->ReleaseGraphicsResources(window);
  auto scalars = vtkDataArray::SafeDownCast(source.Scalars);
  auto shading = dynamic_cast<SurfaceFieldShading*>(source.Surface);
  if (!scalars || !shading)
  {
    return true;
  }
  this->ShaderSource = shading->GetFieldShaderSource();
  vtkDataArray* values = source.Surface->FindCoefficients(source.Mesh, scalars);
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return true;
  }
  this->Size = static_cast<int>(values->GetNumberOfTuples());
  const int type = scalars->GetDataType();
  if (source.AreColors)
  {
    const std::vector<float> colors = GetDirectColors(values, type);
    if (colors.empty())
    {
      return true; // VTK's colours of the corners are used
    }
    this->Coloring = FieldColoring::COLORS;
    return this->Colors.Upload(window, colors, 4);
  }
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!this->Numbers.Upload(window, WithoutNoData(values, source.NoDataMagnitude), source.Table,
        source.Component, source.ByTexture, none, type))
  {
    return false;
  }
  const ScalarKind kind = this->Numbers.GetKind();
  this->Coloring = kind == BY_VALUE
    ? FieldColoring::TABLE
    : (kind == BY_TEXTURE ? FieldColoring::TEXTURE : FieldColoring::NONE);
  return true;
}

bool RefinementField::IsUsed(vtkShaderProgram* program) const
{
  return this->Coloring != FieldColoring::NONE && program->IsUniformUsed("relevoFieldSize");
}

void RefinementField::Activate(vtkShaderProgram* program)
{
  program->SetUniformi("relevoFieldSize", this->Size);
  if (this->Coloring == FieldColoring::COLORS)
  {
    this->Colors.Activate(program, "relevoFieldColors");
  }
  else
  {
    this->Numbers.Activate(program);
  }
}

void RefinementField::Deactivate()
{
  this->Numbers.Deactivate();
  this->Colors.Deactivate();
}

vtkTypeInt64 RefinementField::GetMemorySize() const
{
  return this->Numbers.GetMemorySize() + this->Colors.GetMemorySize();
}

void RefinementField::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Coloring = FieldColoring::NONE;
  this->Numbers.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
}
}
