// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ColorTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace relevo
{
namespace
{
// The number of samples of a function, which has no number of colours.
constexpr int Samples = 8192;

// Return the number of colours of a lookup table, each constant in its interval; 0 for a function.
int CountSteps(vtkScalarsToColors* table)
{
  auto* function = vtkDiscretizableColorTransferFunction::SafeDownCast(table);
  const bool isStepped =
    vtkLookupTable::SafeDownCast(table) || (function && function->GetDiscretize());
  return isStepped ? static_cast<int>(std::max<vtkIdType>(
                       1, std::min<vtkIdType>(table->GetNumberOfAvailableColors(), 65000)))
                   : 0;
}

vtkPiecewiseFunction* GetOpacityFunction(vtkScalarsToColors* table)
{
  auto* function = vtkDiscretizableColorTransferFunction::SafeDownCast(table);
  return function && function->GetEnableOpacityMapping() ? function->GetScalarOpacityFunction()
                                                         : nullptr;
}

std::vector<float> GetColors(vtkScalarsToColors* table, vtkDoubleArray* values)
{
  table->Build(); // colours are not computed before
  // As in vtkMapper, the table's alpha is ignored, but not the opacity of its colours.
  const double alpha = table->GetAlpha();
  table->SetAlpha(1.0);
  auto bytes = vtk::TakeSmartPointer(
    table->MapScalars(static_cast<vtkAbstractArray*>(values), VTK_COLOR_MODE_MAP_SCALARS, 0));
  table->SetAlpha(alpha);
  std::vector<float> colors(static_cast<size_t>(bytes->GetNumberOfValues()));
  std::transform(bytes->GetPointer(0), bytes->GetPointer(0) + colors.size(), colors.begin(),
    [](unsigned char component) { return static_cast<float>(component) / 255.0f; });
  return colors;
}
}

std::array<float, 4> ColorTable::GetColor(vtkScalarsToColors* table, double value)
{
  vtkNew<vtkDoubleArray> values;
  values->InsertNextValue(value);
  const std::vector<float> color = GetColors(table, values);
  return { { color[0], color[1], color[2], color[3] } };
}

bool ColorTable::ChooseWhole(const double dataRange[2])
{
  constexpr double most = 65000.0;
  if (!(dataRange[0] <= dataRange[1] && dataRange[1] - dataRange[0] < most))
  {
    return false;
  }
  this->Log = false;
  this->Ends[0] = dataRange[0] - 0.5;
  this->Ends[1] = dataRange[1] + 0.5;
  this->NumberOfColors = static_cast<int>(dataRange[1] - dataRange[0]) + 1;
  return true;
}

std::string ColorTable::FindError(vtkScalarsToColors* table, const double range[2])
{
  if (!vtkLookupTable::SafeDownCast(table))
  {
    return "";
  }
  if (table->GetIndexedLookup())
  {
    return table->GetNumberOfAvailableColors() > 0 ? "" : "the lookup table has no colours";
  }
  double ends[2] = { range[0], range[1] };
  if (table->UsingLogScale())
  {
    vtkLookupTable::GetLogRange(range, ends);
  }
  if (std::isfinite(range[1] - range[0]) && std::isfinite(ends[1] - ends[0]))
  {
    return "";
  }
  std::ostringstream error;
  error << "the range of the lookup table, (" << range[0] << ", " << range[1] << "), "
        << (table->UsingLogScale() ? "or its logarithm " : "") << "is not finite";
  return error.str();
}

bool ColorTable::IsLogarithmic(vtkScalarsToColors* table)
{
  auto* function = vtkColorTransferFunction::SafeDownCast(table);
  return table->UsingLogScale() || (function && function->GetScale() == VTK_CTF_LOG10);
}

void ColorTable::ChooseSamples(vtkScalarsToColors* table, const double dataRange[2])
{
  std::copy_n(table->GetRange(), 2, this->Ends);
  const int steps = CountSteps(table);
  this->NumberOfColors = steps > 0 ? steps : Samples;
  double reach[2] = { this->Ends[0], this->Ends[1] };
  if (vtkPiecewiseFunction* opacity = GetOpacityFunction(table))
  {
    reach[0] = std::min(reach[0], opacity->GetRange()[0]);
    reach[1] = std::max(reach[1], opacity->GetRange()[1]);
  }
  if (steps == 0)
  {
    // Include all whole numbers where there are data and the function changes.
    const double low = std::max(reach[0], dataRange[0]);
    const double high = std::min(reach[1], dataRange[1]);
    this->Ends[0] = low < high ? low : reach[0];
    this->Ends[1] = low < high ? high : reach[1];
  }
  else if (GetOpacityFunction(table) && !this->Log && this->Ends[0] < this->Ends[1])
  {
    // Use several samples per interval, and further intervals on both sides where the opacity still
    // changes.
    const double step = (this->Ends[1] - this->Ends[0]) / steps;
    const double below = std::min(std::ceil((this->Ends[0] - reach[0]) / step), 16384.0);
    const double above = std::min(std::ceil((reach[1] - this->Ends[1]) / step), 16384.0);
    this->Ends[0] -= below * step;
    this->Ends[1] += above * step;
    const int all = steps + static_cast<int>(below + above);
    this->NumberOfColors = all * std::max(1, Samples / all);
  }
}

bool ColorTable::Upload(vtkOpenGLRenderWindow* window, vtkScalarsToColors* table, double bias,
  const double dataRange[2], bool whole)
{
  table->Build(); // computes the range
  this->Log = IsLogarithmic(table);
  const bool wholeSamples = whole && this->ChooseWhole(dataRange);
  if (!wholeSamples)
  {
    this->ChooseSamples(table, dataRange);
  }
  this->Log = this->Log && this->Ends[0] > 0.0 && this->Ends[1] > this->Ends[0];
  double ends[2] = { this->Ends[0], this->Ends[1] };
  if (this->Log)
  {
    ends[0] = std::log10(ends[0]);
    ends[1] = std::log10(ends[1]);
  }
  this->Minimum = static_cast<float>(this->Log ? ends[0] : ends[0] - bias);
  this->Span =
    static_cast<float>(std::max<double>(ends[1] - ends[0], std::numeric_limits<float>::min()));

  // Sample the centre of each interval.
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < this->NumberOfColors; ++i)
  {
    const double value = ends[0] + (i + 0.5) / this->NumberOfColors * (ends[1] - ends[0]);
    values->InsertNextValue(
      this->Log ? std::pow(10.0, value) : (wholeSamples ? std::round(value) : value));
  }
  // Sample next to the ends if the table continues there, otherwise far beyond its range.
  const double span = std::max(this->Ends[1] - this->Ends[0], 1e-3 * std::abs(this->Ends[0]));
  const double out = span > 0.0 ? span : 1.0;
  const bool ends0 = dataRange[0] < this->Ends[0];
  const bool ends1 = dataRange[1] > this->Ends[1];
  values->InsertNextValue(
    ends0 ? (this->Log ? 0.5 * this->Ends[0] : this->Ends[0] - out) : this->Ends[0]);
  values->InsertNextValue(ends1 ? this->Ends[1] + out : this->Ends[1]);
  values->InsertNextValue(vtkMath::Nan());
  return this->Colors.Upload(window, GetColors(table, values), 4);
}

void ColorTable::Activate(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("relevoColorTable"))
  {
    return;
  }
  this->Colors.Activate(program, "relevoColorTable");
  program->SetUniformf("relevoTableMinimum", this->Minimum);
  program->SetUniformf("relevoTableSpan", this->Span);
  program->SetUniformi("relevoTableColors", this->NumberOfColors);
  program->SetUniformi("relevoTableLog", this->Log ? 1 : 0);
}
}
