// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightMapDisplacement.h"

#include "vtkCallbackCommand.h"
#include "vtkHeightMap.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeightMapDisplacement);

vtkHeightMapDisplacement::vtkHeightMapDisplacement() = default;
vtkHeightMapDisplacement::~vtkHeightMapDisplacement() = default;

void vtkHeightMapDisplacement::SetHeightMapFileName(const char* name)
{
  const bool isNamed = name && *name;
  this->Map->SetFileName(isNamed ? name : nullptr);
  this->SetHeightMap(isNamed ? this->Map.Get() : nullptr);
}

const char* vtkHeightMapDisplacement::GetHeightMapFileName()
{
  return this->Map->GetFileName();
}

void vtkHeightMapDisplacement::SetMaximumDimension(int dimension)
{
  this->Map->SetMaximumDimension(dimension);
}

int vtkHeightMapDisplacement::GetMaximumDimension()
{
  return this->Map->GetMaximumDimension();
}

void vtkHeightMapDisplacement::SetAlongNormals(bool along)
{
  this->AlongNormals = along;
  if (along)
  {
    this->SetDirectionToNormal();
  }
  else
  {
    this->SetDirection(this->FixedDirection);
  }
}

void vtkHeightMapDisplacement::SetFixedDirection(double x, double y, double z)
{
  const double direction[3] = { x, y, z };
  const double length = vtkMath::Norm(direction);
  if (!std::isfinite(length) || length == 0.0)
  {
    vtkErrorMacro("FixedDirection must be a finite vector that is not zero, got ("
      << x << ", " << y << ", " << z << ").");
    return;
  }
  std::copy(direction, direction + 3, this->FixedDirection);
  this->SetAlongNormals(this->AlongNormals);
}

bool vtkHeightMapDisplacement::Update()
{
  // VTK does not print errors that have an observer.
  vtkNew<vtkCallbackCommand> quiet;
  quiet->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long ofMap = this->Map->AddObserver(vtkCommand::ErrorEvent, quiet);
  const unsigned long own = this->AddObserver(vtkCommand::ErrorEvent, quiet);
  const bool valid = this->Superclass::Update();
  this->Map->RemoveObserver(ofMap);
  this->RemoveObserver(own);
  return valid;
}

void vtkHeightMapDisplacement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Map:\n";
  this->Map->PrintSelf(os, indent.GetNextIndent());
  os << indent << "AlongNormals: " << this->AlongNormals << "\n";
  os << indent << "FixedDirection: " << this->FixedDirection[0] << " " << this->FixedDirection[1]
     << " " << this->FixedDirection[2] << "\n";
}
