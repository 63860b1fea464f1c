// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementColors.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
bool RefinementColors::Upload(
  vtkOpenGLRenderWindow* window, vtkDataArray* scalars, vtkScalarsToColors* table, int component)
{
  if (table->GetIndexedLookup())
  {
    return false;
  }
  // Which components make the number that is mapped; see vtkScalarsToColors::MapScalars().
  const int numberOfComponents = scalars->GetNumberOfComponents();
  int first = 0;
  int count = 1;
  if (numberOfComponents > 1)
  {
    if (component >= 0)
    {
      first = component;
    }
    else if (table->GetVectorMode() == vtkScalarsToColors::COMPONENT)
    {
      first = table->GetVectorComponent();
    }
    else if (table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
    {
      const int size = table->GetVectorSize();
      first = size > 0 ? table->GetVectorComponent() : 0;
      count = size > 0 ? size : numberOfComponents;
    }
    else
    {
      return false;
    }
    first = std::min(std::max(first, 0), numberOfComponents - 1);
    count = std::min(count, numberOfComponents - first);
  }
  if (count > 4)
  {
    return false;
  }
  this->Magnitude = count > 1;
  this->Log = table->UsingLogScale() != 0;

  double range[2] = { table->GetRange()[0], table->GetRange()[1] };
  // Differences to the minimum keep the digits of narrow ranges far from zero.
  const double bias = this->Magnitude || this->Log ? 0.0 : range[0];
  double ends[2] = { range[0] - bias, range[1] - bias };
  if (this->Log)
  {
    double logarithms[2];
    vtkLookupTable::GetLogRange(range, logarithms);
    std::copy_n(logarithms, 2, ends);
  }
  this->Minimum = static_cast<float>(ends[0]);
  this->Factor = static_cast<float>(
    ends[1] > ends[0] ? 1.0 / (ends[1] - ends[0]) : std::numeric_limits<float>::max());

  const int texel = count == 1 ? 1 : 4;
  const vtkIdType numberOfPoints = scalars->GetNumberOfTuples();
  std::vector<float> values(static_cast<size_t>(texel) * numberOfPoints, 0.0f);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    for (int c = 0; c < count; ++c)
    {
      values[static_cast<size_t>(texel) * i + c] =
        static_cast<float>(scalars->GetComponent(i, first + c) - bias);
    }
  }

  // The table, sampled amid each of its colours; functions are sampled finely.
  this->NumberOfColors = vtkLookupTable::SafeDownCast(table)
    ? static_cast<int>(std::min<vtkIdType>(table->GetNumberOfAvailableColors(), 65536))
    : 4096;
  this->NumberOfColors = std::max(this->NumberOfColors, 1);
  std::vector<float> colors;
  auto addColor = [&](double value)
  {
    const unsigned char* rgba = table->MapValue(value);
    for (int c = 0; c < 4; ++c)
    {
      colors.push_back(static_cast<float>(rgba[c]) / 255.0f);
    }
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
  return this->Scalars.Upload(window, values, texel) && this->Table.Upload(window, colors, 4);
}

void RefinementColors::Activate(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("relevoScalars"))
  {
    return;
  }
  this->Scalars.Activate(program, "relevoScalars");
  this->Table.Activate(program, "relevoScalarTable");
  program->SetUniformf("relevoScalarMinimum", this->Minimum);
  program->SetUniformf("relevoScalarFactor", this->Factor);
  program->SetUniformi("relevoScalarColors", this->NumberOfColors);
  program->SetUniformi("relevoScalarMagnitude", this->Magnitude ? 1 : 0);
  program->SetUniformi("relevoScalarLog", this->Log ? 1 : 0);
}

void RefinementColors::Deactivate()
{
  this->Scalars.Deactivate();
  this->Table.Deactivate();
}

vtkTypeInt64 RefinementColors::GetMemorySize() const
{
  return this->Scalars.GetMemorySize() + this->Table.GetMemorySize();
}

void RefinementColors::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Scalars.ReleaseGraphicsResources(window);
  this->Table.ReleaseGraphicsResources(window);
}
}
