// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementColors.h"

#include "vtkDataArray.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <algorithm>

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
  // Differences to the minimum keep the digits of narrow ranges far from zero.
  const double bias = this->Magnitude || table->UsingLogScale() ? 0.0 : table->GetRange()[0];
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

  return this->Scalars.Upload(window, values, texel) && this->Table.Upload(window, table, bias);
}

void RefinementColors::Activate(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("relevoScalars"))
  {
    return;
  }
  this->Scalars.Activate(program, "relevoScalars");
  this->Table.Activate(program);
  program->SetUniformi("relevoScalarMagnitude", this->Magnitude ? 1 : 0);
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
