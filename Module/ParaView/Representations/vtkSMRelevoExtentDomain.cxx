// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelevoExtentDomain.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRelevoExtentDomain);

int vtkSMRelevoExtentDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  const bool hasLength =
    this->GetNumberOfEntries() > 0 && this->GetMaximumExists(0) && this->GetMaximum(0) > 0.0;
  return hasLength ? this->Superclass::SetDefaultValues(property, useUncheckedValues) : 0;
}

void vtkSMRelevoExtentDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
