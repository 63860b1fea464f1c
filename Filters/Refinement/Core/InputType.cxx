// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/InputType.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkInformationVector.h"

#include <string>

namespace relevo
{
bool CheckInputType(vtkAlgorithm* algorithm, vtkInformationVector* input)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  vtkInformation* port = algorithm->GetInputPortInformation(0);
  vtkInformationStringVectorKey* required = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  std::string types;
  for (int i = 0; i < required->Length(port); ++i)
  {
    if (data && data->IsA(required->Get(port, i)))
    {
      return true;
    }
    types += (i > 0 ? " or a " : "a ") + std::string(required->Get(port, i));
  }
  vtkErrorWithObjectMacro(algorithm,
    "The input is a " << (data ? data->GetClassName() : "nullptr") << "; " << types
                      << " is needed.");
  return false;
}
}
