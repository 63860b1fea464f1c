// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Legend/ArrayUnit.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

//------------------------------------------------------------------------------
std::string GetArrayUnit(vtkDataArray* array)
{
  if (!array->HasInformation() || !array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
  {
    return "";
  }
  return array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
}
