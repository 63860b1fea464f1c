// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelevoRepresentationProxy.h"

#include "PropertyRanges.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRelevoRepresentationProxy);

vtkSMRelevoRepresentationProxy::vtkSMRelevoRepresentationProxy()
  : Ranges(new relevo::PropertyRanges)
{
}

vtkSMRelevoRepresentationProxy::~vtkSMRelevoRepresentationProxy() = default;

void vtkSMRelevoRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
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

void vtkSMRelevoRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
