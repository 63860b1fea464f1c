// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/StepFilter.h"

#include "Text/ViewerMessages.h"

#include "vtkArrayQuantityFilter.h"
#include "vtkDataObject.h"
#include "vtkNew.h"

//------------------------------------------------------------------------------
StepFilter::StepFilter(const MeshWarp& warp, const std::string& array)
  : Warp(warp)
  , Array(array)
{
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> StepFilter::Apply(vtkDataObject* data, ViewerMessages& messages)
{
  this->Error.clear();
  try
  {
    return this->AddQuantity(this->Warp.Apply(data, messages), messages);
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
