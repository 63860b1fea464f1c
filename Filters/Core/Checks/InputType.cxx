// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks/InputType.h"

#include "Checks/LeftOutBlocks.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

namespace relevo
{
namespace
{
const std::string Composite = "vtkCompositeDataSet";

// Returns "CLASS; a CLASS or a CLASS is needed". Blocks are never composite.
std::string DescribeType(vtkDataObject* data, vtkInformation* port, bool isBlock)
{
  vtkInformationStringVectorKey* required = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  std::string types;
  for (int i = 0; i < required->Length(port); ++i)
  {
    const std::string type = required->Get(port, i);
    if (!isBlock || type != Composite)
    {
      types += (types.empty() ? "a " : " or a ") + type;
    }
  }
  return std::string(data ? data->GetClassName() : "nullptr") + "; " + types + " is needed";
}
}

bool IsOfRequiredType(vtkDataObject* data, vtkInformation* port)
{
  vtkInformationStringVectorKey* required = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  bool isOne = false;
  for (int i = 0; i < required->Length(port) && data && !isOne; ++i)
  {
    isOne = data->IsA(required->Get(port, i)) != 0;
  }
  return isOne || required->Length(port) == 0;
}

bool CheckInputTypes(vtkAlgorithm* algorithm, vtkInformationVector** inputs)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* information = algorithm->GetInputPortInformation(port);
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* data = vtkDataObject::GetData(inputs[port], i);
      if (!IsOfRequiredType(data, information))
      {
        const std::string input =
          port > 0 ? "The input of port " + std::to_string(port) + " is a " : "The input is a ";
        vtkErrorWithObjectMacro(
          algorithm, << input << DescribeType(data, information, false) << ".");
        return false;
      }
    }
  }
  return true;
}

std::string FindTypeError(vtkDataObject* input, vtkInformation* port)
{
  if (!IsOfRequiredType(input, port))
  {
    return "The input is a " + DescribeType(input, port, false) + ".";
  }
  LeftOutBlocks wrong;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      vtkDataObject* block = leaf->GetCurrentDataObject();
      if (!IsOfRequiredType(block, port))
      {
        wrong.Add(GetBlockName(leaf), "is a " + DescribeType(block, port, true));
      }
    }
  }
  return wrong.GetText();
}
}
