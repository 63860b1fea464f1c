// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedFaceGeometry.h"

#include "Composite/DataLeaves.h"
#include "FacePolygons.h"
#include "LeafConversion.h"
#include "MapperMessage.h"
#include "vtkCommand.h"
#include "vtkCurvedFaceFilter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace relevo
{
vtkStandardNewMacro(CurvedFaceGeometry);

CurvedFaceGeometry::CurvedFaceGeometry() = default;

CurvedFaceGeometry::~CurvedFaceGeometry() = default;

void CurvedFaceGeometry::AddMessage(vtkObject*, unsigned long event, void* text)
{
  std::string& messages = event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings;
  messages += messages.empty() ? "" : " ";
  messages += this->Prefix + ReadMapperMessage(text);
}

vtkSmartPointer<vtkPolyData> CurvedFaceGeometry::MakePolygons(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkCurvedFaceFilter> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, this, &CurvedFaceGeometry::AddMessage);
  filter->AddObserver(vtkCommand::WarningEvent, this, &CurvedFaceGeometry::AddMessage);
  filter->SetInputData(grid);
  filter->Update();
  return MakeFacePolygons(filter->GetOutput(), grid);
}

int CurvedFaceGeometry::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Errors.clear();
  this->Warnings.clear();
  const auto convert = [this](const DataLeaf& leaf) -> vtkSmartPointer<vtkDataObject>
  {
    this->Prefix = leaf.GetPrefix();
    auto grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data);
    if (grid)
    {
      return this->MakePolygons(grid);
    }
    return leaf.Data;
  };
  return RequestConverted(inputVector, outputVector, convert,
    [&](vtkInformationVector** inputs)
    { return this->Superclass::RequestData(request, inputs, outputVector); });
}
}
