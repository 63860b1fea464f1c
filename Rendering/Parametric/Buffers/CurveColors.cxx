// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/CurveColors.h"

#include "Curves/CurveMesh.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace relevo
{
void CurveColors::Clear(vtkWindow* window)
{
  this->Coloring = CurveColoring::ACTOR;
  this->Cells.ReleaseGraphicsResources(window);
  this->Points.ReleaseGraphicsResources(window);
  this->Values.ReleaseGraphicsResources(window);
}

bool CurveColors::UploadCells(
  vtkOpenGLRenderWindow* window, const CurveMesh& curves, vtkUnsignedCharArray* colors)
{
  this->Clear(window);
  std::vector<unsigned int> packed;
  packed.reserve(curves.GetCurves().size());
  for (const CurveMesh::Curve& curve : curves.GetCurves())
  {
    // Field data may have one colour for all.
    const unsigned char* color =
      colors->GetPointer(4 * std::min(curve.Cell, colors->GetNumberOfTuples() - 1));
    packed.push_back(static_cast<unsigned int>(color[0]) |
      static_cast<unsigned int>(color[1]) << 8 | static_cast<unsigned int>(color[2]) << 16 |
      static_cast<unsigned int>(color[3]) << 24);
  }
  this->Coloring = CurveColoring::CELLS;
  return this->Cells.Upload(window, packed);
}

bool CurveColors::UploadPoints(
  vtkOpenGLRenderWindow* window, const CurveMesh& curves, vtkUnsignedCharArray* colors)
{
  this->Clear(window);
  this->Coloring = CurveColoring::POINTS;
  const std::vector<double> coefficients = curves.ComputeCoefficients(colors);
  return this->Points.Upload(
    window, std::vector<float>(coefficients.begin(), coefficients.end()), 4);
}

bool CurveColors::UploadValues(vtkOpenGLRenderWindow* window, const CurveMesh& curves,
  vtkDataArray* values, vtkScalarsToColors* table, int component, bool ofFragments)
{
  this->Clear(window);
  std::vector<double> coefficients = curves.ComputeCoefficients(values);
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(values->GetNumberOfComponents());
  array->SetArray(coefficients.data(), static_cast<vtkIdType>(coefficients.size()), 1);
  if (!this->Values.Upload(window, array, table, component, false,
        std::numeric_limits<double>::infinity(), values->GetDataType()))
  {
    return false;
  }
  if (this->Values.GetKind() == BY_VALUE)
  {
    this->Coloring = ofFragments ? CurveColoring::VALUES_OF_FRAGMENTS : CurveColoring::VALUES;
  }
  return true;
}

void CurveColors::Activate(vtkShaderProgram* program)
{
  this->Cells.Activate(program, "relevoCellColors");
  this->Points.Activate(program, "relevoScalars");
  if (this->Points.IsEmpty())
  {
    this->Values.Activate(program);
  }
}

void CurveColors::Deactivate()
{
  this->Cells.Deactivate();
  this->Points.Deactivate();
  this->Values.Deactivate();
}

vtkTypeInt64 CurveColors::GetMemorySize() const
{
  return this->Cells.GetMemorySize() + this->Points.GetMemorySize() + this->Values.GetMemorySize();
}
}
