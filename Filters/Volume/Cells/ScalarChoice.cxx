// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ScalarChoice.h"

#include "Integral/ScalarTable.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace relevo
{
namespace
{
// The values of vtkSmartVolumeMapper.
enum VectorModes
{
  Disabled = -1,
  Magnitude = 0
};
}

ScalarChoice ChooseScalars(vtkVolumeProperty* property, int vectorMode, int vectorComponent)
{
  // Dependent components are values and opacities, or colours.
  const bool hasMagnitudeColors = property->GetIndependentComponents() &&
    property->GetColorChannels() == 3 &&
    property->GetRGBTransferFunction()->GetVectorMode() == vtkScalarsToColors::MAGNITUDE;
  ScalarChoice choice;
  if (vectorMode == Magnitude || (vectorMode == Disabled && hasMagnitudeColors))
  {
    choice.Component = ScalarChoice::Length;
  }
  else if (vectorMode != Disabled)
  {
    choice.Component = vectorComponent;
  }
  return choice;
}

std::vector<double> AddScalars(vtkDataArray* array, const ScalarChoice& choice, ScalarTable& all)
{
  const int components = array->GetNumberOfComponents();
  // A single component keeps its sign, as in VTK's volume mappers.
  const int component =
    choice.Component == ScalarChoice::Length && components == 1 ? 0 : choice.Component;
  const size_t first = all.size();
  all.Prepare(static_cast<size_t>(array->GetNumberOfTuples()),
    component == ScalarChoice::All ? components : 1);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    Scalars scalars = {};
    if (component == ScalarChoice::All)
    {
      for (int c = 0; c < components; ++c)
      {
        scalars[c] = choice.Scale * array->GetComponent(i, c);
      }
    }
    else if (component == ScalarChoice::Length)
    {
      for (int c = 0; c < components; ++c)
      {
        scalars[0] = std::hypot(scalars[0], array->GetComponent(i, c));
      }
    }
    else
    {
      scalars[0] = array->GetComponent(i, component);
    }
    all.push_back(scalars);
  }
  return all.ReplaceFillValues(first);
}
}
