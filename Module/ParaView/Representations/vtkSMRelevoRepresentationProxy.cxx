// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelevoRepresentationProxy.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRelevoRepresentationProxy);

vtkSMRelevoRepresentationProxy::vtkSMRelevoRepresentationProxy() = default;

vtkSMRelevoRepresentationProxy::~vtkSMRelevoRepresentationProxy() = default;

void vtkSMRelevoRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
