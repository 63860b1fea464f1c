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
namespace
{
// "a CLASS or a CLASS" that the port takes; "" if the data is one of them.
std::string FindMissingType(vtkDataObject* data, vtkInformation* port)
{
  vtkInformationStringVectorKey* required = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  std::string types;
  for (int i = 0; i < required->Length(port); ++i)
  {
    if (data && data->IsA(required->Get(port, i)))
    {
      return "";
    }
    types += (i > 0 ? " or a " : "a ") + std::string(required->Get(port, i));
  }
  return types;
}
}

bool CheckInputTypes(vtkAlgorithm* algorithm, vtkInformationVector** inputs)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* data = vtkDataObject::GetData(inputs[port], i);
      const std::string types = FindMissingType(data, algorithm->GetInputPortInformation(port));
      if (!types.empty())
      {
        const std::string input =
          port > 0 ? "The input of port " + std::to_string(port) + " is a " : "The input is a ";
        vtkErrorWithObjectMacro(algorithm,
          << input << (data ? data->GetClassName() : "nullptr") << "; " << types << " is needed.");
        return false;
      }
    }
  }
  return true;
}
}
