// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/InputCheck.h"

#include "Checks/InputType.h"
#include "Checks/ShouldReport.h"

namespace relevo
{
StageResult InputCheck::Update(vtkDataObject* input, vtkInformation* port)
{
  if (this->Input != input)
  {
    this->Input = input;
    this->Error.clear();
  }
  StageResult result;
  if (ShouldReport(this->Error, input ? FindTypeError(input, port) : ""))
  {
    result.Errors.push_back(this->Error);
  }
  result.IsValid = !input || IsOfRequiredType(input, port);
  return result;
}
}
