// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/StepFilter.h"

#include "Text/ViewerMessages.h"

#include "vtkArrayQuantityFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIntegrationPointAverage.h"
#include "vtkIntegrationPoints.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{
bool HasArray(vtkDataObject* data, const std::string& name)
{
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    if (block->GetCellData()->HasArray(name.c_str()) ||
      block->GetFieldData()->HasArray(name.c_str()))
    {
      return true;
    }
  }
  return false;
}

// The array of a quantity such as "von Mises of Stress".
std::string FindSource(vtkDataObject* data, const std::string& quantity)
{
  const std::string joint = " of ";
  const std::size_t place = quantity.find(joint);
  return HasArray(data, quantity) || place == std::string::npos
    ? quantity
    : quantity.substr(place + joint.size());
}

// The number of components of a cell array, or 0.
int CountComponents(vtkDataObject* data, const std::string& name)
{
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    if (vtkDataArray* array = block->GetCellData()->GetArray(name.c_str()))
    {
      return array->GetNumberOfComponents();
    }
  }
  return 0;
}
}

//------------------------------------------------------------------------------
StepFilter::StepFilter(
  const MeshWarp& warp, const std::string& array, const std::string& integrationPoints)
  : Warp(warp)
  , Array(array)
  , PointArray(integrationPoints)
{
}

//------------------------------------------------------------------------------
StepFilter::~StepFilter() = default;

//------------------------------------------------------------------------------
vtkPolyData* StepFilter::GetIntegrationPoints() const
{
  return this->Points;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> StepFilter::Apply(vtkDataObject* data, ViewerMessages& messages)
{
  this->Error.clear();
  try
  {
    const auto moved = this->Warp.Apply(data, messages);
    this->FindPoints(moved, messages);
    return this->AddQuantity(this->Average(moved, messages), messages);
  }
  catch (const ViewerError& error)
  {
    this->Error = error.what();
    return nullptr;
  }
}

//------------------------------------------------------------------------------
void StepFilter::Check(const std::string& fileName) const
{
  if (!this->Error.empty())
  {
    throw ViewerError(fileName + ": " + this->Error);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> StepFilter::Average(vtkDataObject* data, ViewerMessages& messages)
{
  vtkNew<vtkIntegrationPointAverage> average;
  messages.Observe(average);
  average->SetInputData(data);
  average->Update();
  messages.Check();
  const std::string source = FindSource(data, this->Array);
  this->ShowsAverage =
    CountComponents(data, source) == 0 && CountComponents(average->GetOutput(), source) > 0;
  return average->GetOutput();
}

//------------------------------------------------------------------------------
void StepFilter::FindPoints(vtkDataObject* data, ViewerMessages& messages)
{
  if (this->PointArray.empty())
  {
    return;
  }
  const std::string source = FindSource(data, this->PointArray);
  vtkNew<vtkIntegrationPoints> points;
  messages.Observe(points);
  points->SetInputData(data);
  points->SetArrayName(source.c_str());
  vtkNew<vtkArrayQuantityFilter> quantity;
  messages.Observe(quantity);
  quantity->SetInputConnection(points->GetOutputPort());
  quantity->SetQuantity(this->PointArray.c_str());
  quantity->Update();
  messages.Check();
  this->Points = vtkPolyData::SafeDownCast(quantity->GetOutput());
  if (this->Array.empty())
  {
    // The cells show averages: of an array with a component for each point, the mean of these.
    this->Array =
      CountComponents(data, source) > 1 ? "mean of " + source : std::string(this->PointArray);
  }
  this->PointArray = quantity->GetResultName();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> StepFilter::AddQuantity(
  vtkDataObject* data, ViewerMessages& messages)
{
  if (this->Array.empty())
  {
    return data;
  }
  vtkNew<vtkArrayQuantityFilter> filter;
  messages.Observe(filter);
  filter->SetInputData(data);
  filter->SetQuantity(this->Array.c_str());
  filter->Update();
  messages.Check();
  this->Array = filter->GetResultName();
  return filter->GetOutput();
}
