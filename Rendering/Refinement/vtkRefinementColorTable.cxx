// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementColorTable.h"

#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
std::array<float, 4> RefinementColorTable::GetColor(vtkScalarsToColors* table, double value)
{
  const unsigned char* rgba = table->MapValue(value);
  std::array<float, 4> color;
  std::transform(rgba, rgba + 4, color.begin(),
    [](unsigned char component) { return static_cast<float>(component) / 255.0f; });
  return color;
}

bool RefinementColorTable::Upload(
  vtkOpenGLRenderWindow* window, vtkScalarsToColors* table, double bias)
{
  this->Log = table->UsingLogScale() != 0;
  double range[2] = { table->GetRange()[0], table->GetRange()[1] };
  double ends[2] = { range[0] - bias, range[1] - bias };
  if (this->Log)
  {
    vtkLookupTable::GetLogRange(range, ends);
  }
  this->Minimum = static_cast<float>(ends[0]);
  this->Factor = static_cast<float>(
    ends[1] > ends[0] ? 1.0 / (ends[1] - ends[0]) : std::numeric_limits<float>::max());

  // Sampled amid each of its colours; functions are sampled finely.
  this->NumberOfColors = vtkLookupTable::SafeDownCast(table)
    ? static_cast<int>(std::min<vtkIdType>(table->GetNumberOfAvailableColors(), 65536))
    : 4096;
  this->NumberOfColors = std::max(this->NumberOfColors, 1);
  std::vector<float> colors;
  auto addColor = [&](double value)
  {
    const std::array<float, 4> color = GetColor(table, value);
    colors.insert(colors.end(), color.begin(), color.end());
  };
  for (int i = 0; i < this->NumberOfColors; ++i)
  {
    const double value =
      (this->Log ? ends[0] : range[0]) + (i + 0.5) / this->NumberOfColors * (ends[1] - ends[0]);
    addColor(this->Log ? std::pow(10.0, value) : value);
  }
  const double span = std::max(range[1] - range[0], 1e-3 * std::abs(range[0]));
  addColor(this->Log ? 0.5 * range[0] : range[0] - (span > 0.0 ? span : 1.0));
  addColor(range[1] + (span > 0.0 ? span : 1.0));
  addColor(vtkMath::Nan());
  return this->Colors.Upload(window, colors, 4);
}

void RefinementColorTable::Activate(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("relevoColorTable"))
  {
    return;
  }
  this->Colors.Activate(program, "relevoColorTable");
  program->SetUniformf("relevoTableMinimum", this->Minimum);
  program->SetUniformf("relevoTableFactor", this->Factor);
  program->SetUniformi("relevoTableColors", this->NumberOfColors);
  program->SetUniformi("relevoTableLog", this->Log ? 1 : 0);
}
}
