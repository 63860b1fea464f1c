// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks/StageReport.h"

#include "vtkObject.h"

namespace relevo
{
void StageReport::InvokeEvents(vtkObject* object) const
{
  for (const std::string& error : this->Errors)
  {
    vtkErrorWithObjectMacro(object, << error);
  }
  for (const std::string& warning : this->Warnings)
  {
    vtkWarningWithObjectMacro(object, << warning);
  }
}
}
