// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementSurface.h"

vtkRefinementSurface::vtkRefinementSurface() = default;
vtkRefinementSurface::~vtkRefinementSurface() = default;

void vtkRefinementSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
