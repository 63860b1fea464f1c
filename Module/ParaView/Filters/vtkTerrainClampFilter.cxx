// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainClampFilter.h"

#include "Changes/LatestTime.h"
#include "Checks/ErrorCollector.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTerrainClamp.h"
#include "vtkTerrainPyramid.h"

#include <string>

namespace
{
// Return the mesh with its points moved by a factor of the offset.
vtkSmartPointer<vtkPolyData> Shift(vtkPolyData* mesh, const double offset[3], double factor)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  if (!mesh->GetPoints())
  {
    return moved;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] += factor * offset[axis];
    }
    points->SetPoint(i, point);
  }
  moved->SetPoints(points);
  return moved;
}
}

vtkStandardNewMacro(vtkTerrainClampFilter);

vtkTerrainClampFilter::vtkTerrainClampFilter()
{
  this->SetNumberOfInputPorts(2);
  for (vtkObject* reporter : { static_cast<vtkObject*>(this->Clamp), //
         static_cast<vtkObject*>(this->Pyramid) })
  {
    reporter->AddObserver(vtkCommand::ErrorEvent, this, &vtkTerrainClampFilter::Report);
    reporter->AddObserver(vtkCommand::WarningEvent, this, &vtkTerrainClampFilter::Report);
  }
}

vtkTerrainClampFilter::~vtkTerrainClampFilter() = default;

void vtkTerrainClampFilter::Report(vtkObject*, unsigned long event, void* text)
{
  // The text begins with the file, class and address.
  std::string message = text ? static_cast<const char*>(text) : "";
  const std::size_t begin = message.find("): ");
  message = begin == std::string::npos ? message : message.substr(begin + 3);
  message.erase(message.find_last_not_of(" \n") + 1);
  if (event == vtkCommand::ErrorEvent)
  {
    vtkErrorMacro(<< message);
  }
  else
  {
    vtkWarningMacro(<< message);
  }
}

void vtkTerrainClampFilter::SetCoordinateType(int type)
{
  this->Clamp->SetCoordinateType(type);
}

int vtkTerrainClampFilter::GetCoordinateType()
{
  return this->Clamp->GetCoordinateType();
}

void vtkTerrainClampFilter::SetOffset(double distance)
{
  this->Clamp->SetOffset(distance);
}

double vtkTerrainClampFilter::GetOffset()
{
  return this->Clamp->GetOffset();
}

void vtkTerrainClampFilter::SetExaggeration(double factor)
{
  this->Clamp->SetExaggeration(factor);
}

double vtkTerrainClampFilter::GetExaggeration()
{
  return this->Clamp->GetExaggeration();
}

vtkMTimeType vtkTerrainClampFilter::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(), { this->Clamp });
}

int vtkTerrainClampFilter::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkTerrainClampFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkFieldData* terrain = vtkPolyData::GetData(inputVector[1])->GetFieldData();
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  auto name = vtkStringArray::SafeDownCast(terrain->GetAbstractArray("FileName"));
  auto offset = vtkDoubleArray::SafeDownCast(terrain->GetAbstractArray("Offset"));
  if (!name || name->GetNumberOfValues() == 0 || !offset || offset->GetNumberOfValues() != 3)
  {
    vtkErrorMacro("Terrain is not the output of a Terrain Reader. Select one.");
    return 1; // the pipeline would report a second error
  }
  if (input->GetNumberOfPoints() == 0) // ParaView's ranks without a piece
  {
    return 1;
  }
  this->Pyramid->SetFileName(name->GetValue(0).c_str());
  this->Clamp->SetPyramid(this->Pyramid);
  const bool isOfReader = this->Clamp->GetCoordinateType() == vtkTerrainClamp::WORLD;
  const auto shifted = Shift(input, offset->GetPointer(0), isOfReader ? -1.0 : 0.0);
  this->Clamp->SetInputData(shifted);
  std::string repeated; // the executive repeats errors of the algorithm
  const unsigned long tag = this->Clamp->GetExecutive()->AddObserver(
    vtkCommand::ErrorEvent, relevo::NewErrorCollector(repeated));
  this->Clamp->Update();
  this->Clamp->GetExecutive()->RemoveObserver(tag);
  output->ShallowCopy(Shift(this->Clamp->GetOutput(), offset->GetPointer(0), 1.0));
  this->Clamp->SetInputData(nullptr);
  return 1;
}

void vtkTerrainClampFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Clamp:\n";
  this->Clamp->PrintSelf(os, indent.GetNextIndent());
}
