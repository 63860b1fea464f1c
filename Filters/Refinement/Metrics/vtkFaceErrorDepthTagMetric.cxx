// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFaceErrorDepthTagMetric.h"

#include "Checks/SettingChecks.h"

namespace
{
constexpr double SmallestFaceError = 0.001; // pixels
constexpr double LargestFaceError = 1e6;
}

vtkFaceErrorDepthTagMetric::vtkFaceErrorDepthTagMetric() = default;
vtkFaceErrorDepthTagMetric::~vtkFaceErrorDepthTagMetric() = default;

void vtkFaceErrorDepthTagMetric::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(
    this, "ScreenSpaceError", this->ScreenSpaceError, pixels, SmallestFaceError, LargestFaceError);
}

void vtkFaceErrorDepthTagMetric::SetMaximumError(double length)
{
  relevo::SetInRange(this, "MaximumError", this->MaximumError, length, 0.0, relevo::LargestDouble);
}

void vtkFaceErrorDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "MaximumLevelOnBorder: " << (this->MaximumLevelOnBorder ? "on" : "off") << "\n";
}
