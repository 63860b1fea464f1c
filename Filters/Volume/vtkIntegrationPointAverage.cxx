// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntegrationPointAverage.h"

#include "Compatibility/VTKCompatibility.h"
#include "Quantities/QuadratureScheme.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkQuadratureSchemeDefinition.h"

#include <vector>

vtkStandardNewMacro(vtkIntegrationPointAverage);

namespace
{
void AddAverages(vtkDataSet* data, vtkDataArray* values, const relevo::QuadratureScheme& scheme)
{
  const int components = values->GetNumberOfComponents();
  vtkNew<vtkDoubleArray> means;
  means->SetName(values->GetName());
  means->SetNumberOfComponents(components);
  means->SetNumberOfTuples(data->GetNumberOfCells());
  for (int c = 0; c < components; ++c)
  {
    if (values->GetComponentName(c))
    {
      means->SetComponentName(c, values->GetComponentName(c));
    }
  }
  std::vector<double> tuple(static_cast<std::size_t>(components));
  std::vector<double> sum(static_cast<std::size_t>(components));
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkQuadratureSchemeDefinition* definition = scheme.GetDefinition(cell);
    std::fill(sum.begin(), sum.end(), definition ? 0.0 : vtkMath::Nan());
    const int number = definition ? definition->GetNumberOfQuadraturePoints() : 0;
    for (int i = 0; i < number; ++i)
    {
      values->GetTuple(scheme.GetFirst(cell) + i, tuple.data());
      for (int c = 0; c < components; ++c)
      {
        sum[c] += tuple[c] / number;
      }
    }
    means->SetTuple(cell, sum.data());
  }
  data->GetCellData()->AddArray(means);
}
}

vtkIntegrationPointAverage::vtkIntegrationPointAverage() = default;

vtkIntegrationPointAverage::~vtkIntegrationPointAverage() = default;

int vtkIntegrationPointAverage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkIntegrationPointAverage::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  relevo::CopyWithOwnBlocks(vtkDataObject::GetData(inputVector[0]), output);
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(output))
  {
    for (vtkDataArray* values : relevo::FindIntegrationPointArrays(block))
    {
      if (block->GetCellData()->HasArray(values->GetName()))
      {
        continue;
      }
      const relevo::QuadratureScheme scheme(block, values);
      if (!scheme.GetError().empty())
      {
        vtkWarningMacro("The array '"
          << values->GetName()
          << "' of values at integration points is left out: " << scheme.GetError() << ".");
        continue;
      }
      AddAverages(block, values, scheme);
    }
  }
  return 1;
}

void vtkIntegrationPointAverage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
