// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkArrayQuantityFilter.h"

#include "Compatibility/VTKCompatibility.h"
#include "Quantities/ArrayQuantity.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkArrayQuantityFilter);

namespace
{
std::vector<vtkDataSetAttributes*> GetAttributes(vtkDataObject* data)
{
  std::vector<vtkDataSetAttributes*> attributes;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    attributes.push_back(block->GetPointData());
    attributes.push_back(block->GetCellData());
  }
  return attributes;
}

// The names of arrays from which the quantity can be computed.
std::vector<std::string> FindSources(
  const std::vector<vtkDataSetAttributes*>& attributes, const relevo::ArrayQuantity& quantity)
{
  std::vector<std::string> names;
  for (vtkDataSetAttributes* data : attributes)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName() && quantity.CanUse(array->GetNumberOfComponents()) &&
        std::find(names.begin(), names.end(), array->GetName()) == names.end())
      {
        names.emplace_back(array->GetName());
      }
    }
  }
  return names;
}

// "'a', 'b'"
std::string List(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return list.empty() ? "none" : list;
}
}

vtkArrayQuantityFilter::vtkArrayQuantityFilter() = default;

vtkArrayQuantityFilter::~vtkArrayQuantityFilter() = default;

int vtkArrayQuantityFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkArrayQuantityFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  relevo::CopyWithOwnBlocks(vtkDataObject::GetData(inputVector[0]), output);
  this->ResultName = this->Quantity;
  std::optional<relevo::ArrayQuantity> quantity = relevo::ParseQuantity(this->Quantity);
  const std::vector<vtkDataSetAttributes*> attributes = GetAttributes(output);
  const bool exists = std::any_of(attributes.begin(), attributes.end(),
    [&](vtkDataSetAttributes* data) { return data->HasArray(this->Quantity.c_str()); });
  if (!quantity || exists)
  {
    return 1;
  }
  const std::vector<std::string> sources = FindSources(attributes, *quantity);
  if (quantity->Source.empty() && sources.size() > 1)
  {
    vtkErrorMacro("'" << this->Quantity << "': the input has several tensors, " << List(sources)
                      << "; choose one, such as '" << quantity->Name << " of " << sources[0]
                      << "'.");
    return 0;
  }
  if (quantity->Source.empty() && !sources.empty())
  {
    quantity->Source = sources[0];
  }
  if (std::find(sources.begin(), sources.end(), quantity->Source) == sources.end())
  {
    const bool isMissing = !quantity->Source.empty() &&
      std::none_of(attributes.begin(), attributes.end(),
        [&](vtkDataSetAttributes* data) { return data->HasArray(quantity->Source.c_str()); });
    const std::string cause = isMissing
      ? "there is no array '" + quantity->Source + "'; arrays with "
      : "needs an array with ";
    vtkErrorMacro("'" << this->Quantity << "'" << (isMissing ? ": " : " ") << cause
                      << quantity->GetNeed() << (isMissing ? " are " : "; the input has ")
                      << List(sources) << ".");
    return 0;
  }
  this->ResultName = quantity->Name + " of " + quantity->Source;
  for (vtkDataSetAttributes* data : attributes)
  {
    vtkDataArray* source = data->GetArray(quantity->Source.c_str());
    if (source && quantity->CanUse(source->GetNumberOfComponents()))
    {
      const vtkSmartPointer<vtkDataArray> result = quantity->Compute(source);
      result->SetName(this->ResultName.c_str());
      data->AddArray(result);
    }
  }
  return 1;
}

void vtkArrayQuantityFilter::ListQuantities(
  const char* arrayName, int numberOfComponents, vtkStringArray* quantities)
{
  quantities->Initialize();
  for (const std::string& name : relevo::FindQuantities(numberOfComponents))
  {
    quantities->InsertNextValue(name + " of " + (arrayName ? arrayName : ""));
  }
}

void vtkArrayQuantityFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quantity: " << this->Quantity << "\n";
  os << indent << "ResultName: " << this->ResultName << "\n";
}
