// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementField.h"

#include "Arrays/NoDataTuples.h"
#include "Surfaces/SurfaceFieldShading.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

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

bool RefinementField::Upload(vtkOpenGLRenderWindow* window, vtkRefinementSurface* surface,
  vtkPolyData* mesh, const FieldScalars& scalars, bool areOfCells)
{
  auto shading = dynamic_cast<SurfaceFieldShading*>(surface);
  vtkSmartPointer<vtkDataArray> values;
  Dependencies source = Dependencies::On(areOfCells);
  if (scalars.Array && shading && areOfCells)
  {
    values = shading->FindCellValues(mesh, scalars.Array);
    source.AddObject(scalars.Array);
    source.AddObject(mesh);
  }
  else if (scalars.Array && shading)
  {
    values = surface->FindCoefficients(mesh, scalars.Array);
    source.AddObject(values.Get());
  }
  if (!values || values->GetNumberOfTuples() == 0)
  {
    this->ReleaseGraphicsResources(window);
    return true;
  }
  this->ShaderSource =
    areOfCells ? shading->GetCellFieldShaderSource() : shading->GetFieldShaderSource();
  this->Size = static_cast<int>(values->GetNumberOfTuples());
  return this->Coefficients.Upload(window, source, scalars, values,
    [&] { return WithoutNoData(values, scalars.NoDataMagnitude); });
}

bool RefinementField::IsUsed(vtkShaderProgram* program) const
{
  return this->GetColoring() != FieldColoring::NONE && program->IsUniformUsed("relevoFieldSize");
}

void RefinementField::Activate(vtkShaderProgram* program)
{
  program->SetUniformi("relevoFieldSize", this->Size);
  this->Coefficients.Activate(program);
}

void RefinementField::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Coefficients.ReleaseGraphicsResources(window);
}
}
