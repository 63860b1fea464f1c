// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelevoProxy.h"

#include "PropertyRanges.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRelevoProxy);

vtkSMRelevoProxy::vtkSMRelevoProxy()
  : Ranges(new relevo::PropertyRanges)
{
}

vtkSMRelevoProxy::~vtkSMRelevoProxy() = default;

void vtkSMRelevoProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  const bool isInitialized = this->ObjectsCreated != 0;
  const std::string error = flag ? this->Ranges->Restore(this, name, isInitialized) : "";
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return; // restoring the value has called this method
  }
  this->Superclass::SetPropertyModifiedFlag(name, flag);
}

void vtkSMRelevoProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
