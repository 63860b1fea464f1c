// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntegrationPoints.h"

#include "Quantities/PointCollector.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkIntegrationPoints);

namespace
{
// "3 vtkPyramid, 1 vtkPolygon"
std::string CountOthers(const relevo::PointCollector& points)
{
  std::string text;
  for (const auto& type : points.GetOtherCells())
  {
    text += (text.empty() ? "" : ", ") + std::to_string(type.second) + " " + type.first;
  }
  return text;
}
}

vtkIntegrationPoints::vtkIntegrationPoints() = default;

vtkIntegrationPoints::~vtkIntegrationPoints() = default;

int vtkIntegrationPoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkIntegrationPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ArrayName.empty())
  {
    vtkErrorMacro("There is no array; call SetArrayName().");
    return 0;
  }
  relevo::PointCollector points(this->ArrayName);
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(vtkDataObject::GetData(inputVector[0])))
  {
    const std::string error = points.Add(block);
    if (!error.empty())
    {
      vtkErrorMacro("The array '" << this->ArrayName
                                  << "' cannot be shown at integration points: " << error << ".");
      return 0;
    }
  }
  if (!points.HasArray())
  {
    vtkErrorMacro("There is no array '"
      << this->ArrayName
      << "' of field data with a quadrature scheme, and no cell array of this name.");
    return 0;
  }
  const std::string others = CountOthers(points);
  if (points.GetNumberOfPoints() == 0)
  {
    if (others.empty())
    {
      vtkErrorMacro("The array '" << this->ArrayName << "' has no values at integration points.");
      return 0;
    }
    vtkErrorMacro("The array '" << this->ArrayName
                                << "' has no integration points: there is no rule for " << others
                                << ".");
    return 0;
  }
  if (!others.empty())
  {
    vtkWarningMacro("The array '" << this->ArrayName << "' has no integration points in " << others
                                  << ", for which there is no rule.");
  }
  points.Finish(vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkIntegrationPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}
