// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthTagMetric.h"

vtkDepthTagMetric::vtkDepthTagMetric() = default;
vtkDepthTagMetric::~vtkDepthTagMetric() = default;

void vtkDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
