// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Quantities/QuadratureScheme.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationQuadratureSchemeDefinitionVectorKey.h"
#include "vtkInformationStringKey.h"
#include "vtkQuadratureSchemeDefinition.h"

namespace relevo
{
QuadratureScheme::QuadratureScheme(vtkDataSet* data, vtkDataArray* values)
  : Data(data)
{
  const char* name =
    values->GetInformation()->Get(vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME());
  this->Offsets = name ? data->GetCellData()->GetArray(name) : nullptr;
  if (!this->Offsets)
  {
    this->Error = "there is no cell array '" + std::string(name ? name : "") + "' of offsets";
    return;
  }
  if (this->Offsets->GetNumberOfTuples() < data->GetNumberOfCells() ||
    this->Offsets->GetNumberOfComponents() != 1)
  {
    this->Error = "the cell array '" + std::string(name) + "' needs one offset for each cell";
    return;
  }
  vtkInformation* information = this->Offsets->GetInformation();
  auto* key = vtkQuadratureSchemeDefinition::DICTIONARY();
  const int size = information->Has(key) ? key->Size(information) : 0;
  for (int type = 0; type < size; ++type)
  {
    this->Definitions.push_back(key->Get(information, type));
  }
  if (this->Definitions.empty())
  {
    this->Error = "the cell array '" + std::string(name) + "' has no quadrature schemes";
    return;
  }
  this->Check(values);
}

void QuadratureScheme::Check(vtkDataArray* values)
{
  const double number = static_cast<double>(values->GetNumberOfTuples());
  for (vtkIdType cell = 0; cell < this->Data->GetNumberOfCells(); ++cell)
  {
    vtkQuadratureSchemeDefinition* definition = this->GetDefinition(cell);
    if (!definition)
    {
      continue;
    }
    const double first = this->Offsets->GetComponent(cell, 0);
    const bool isInside =
      first >= 0.0 && first + definition->GetNumberOfQuadraturePoints() <= number;
    if (!isInside)
    {
      this->Error = "the values of cell " + std::to_string(cell) + " are beyond the " +
        std::to_string(values->GetNumberOfTuples()) + " tuples of the array";
      return;
    }
  }
}

vtkQuadratureSchemeDefinition* QuadratureScheme::GetDefinition(vtkIdType cell) const
{
  const auto type = static_cast<std::size_t>(this->Data->GetCellType(cell));
  vtkQuadratureSchemeDefinition* definition =
    type < this->Definitions.size() ? this->Definitions[type] : nullptr;
  return definition && definition->GetNumberOfQuadraturePoints() > 0 ? definition : nullptr;
}

vtkIdType QuadratureScheme::GetFirst(vtkIdType cell) const
{
  return static_cast<vtkIdType>(this->Offsets->GetComponent(cell, 0));
}

std::vector<vtkDataArray*> FindIntegrationPointArrays(vtkDataSet* data)
{
  std::vector<vtkDataArray*> arrays;
  vtkFieldData* fields = data->GetFieldData();
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i);
    if (array && array->GetName() && array->HasInformation() &&
      array->GetInformation()->Has(vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME()))
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}
}
