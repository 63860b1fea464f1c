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
  const vtkSmartPointer<vtkDataObject> moved = this->Warp.Apply(data, messages);
  if (this->Array.empty())
  {
    return moved;
  }
  vtkNew<vtkArrayQuantityFilter> filter;
  messages.Observe(filter);
  filter->SetInputData(moved);
  filter->SetQuantity(this->Array.c_str());
  filter->Update();
  messages.Check();
  this->Array = filter->GetResultName();
  return filter->GetOutput();
}
