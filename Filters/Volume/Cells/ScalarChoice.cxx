// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ScalarChoice.h"

#include "vtkColorTransferFunction.h"
#include "vtkVolumeProperty.h"

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
}
