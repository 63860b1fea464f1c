// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDisplacement.h"

#include "Checks/SettingChecks.h"
#include "vtkHeightField.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkDisplacement);

vtkDisplacement::vtkDisplacement() = default;
vtkDisplacement::~vtkDisplacement() = default;

vtkCxxSetSmartPointerMacro(vtkDisplacement, HeightMap, vtkHeightField);

vtkHeightField* vtkDisplacement::GetHeightMap()
{
  return this->HeightMap;
}

void vtkDisplacement::SetScale(double scale)
{
  relevo::SetInRange(
    this, "Scale", this->Scale, scale, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkDisplacement::SetOffset(double offset)
{
  relevo::SetInRange(
    this, "Offset", this->Offset, offset, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkDisplacement::SetDirectionToNormal()
{
  if (!this->AlongNormal)
  {
    this->AlongNormal = true;
    this->Modified();
  }
}

void vtkDisplacement::SetDirection(double x, double y, double z)
{
  double direction[3] = { x, y, z };
  const double length = vtkMath::Normalize(direction);
  if (!std::isfinite(length) || length == 0.0)
  {
    vtkErrorMacro("Direction must be a finite vector that is not zero, got (" << x << ", " << y
                                                                              << ", " << z << ").");
    return;
  }
  if (this->AlongNormal || !std::equal(direction, direction + 3, this->Direction))
  {
    std::copy(direction, direction + 3, this->Direction);
    this->AlongNormal = false;
    this->Modified();
  }
}

void vtkDisplacement::SetNoDataPolicy(int policy)
{
  relevo::SetChoice(this, "NoDataPolicy", this->NoDataPolicy, policy, { "HOLE", "FILL" });
}

bool vtkDisplacement::Update()
{
  if (this->HeightMap && !this->HeightMap->Update())
  {
    vtkErrorMacro("The height map " << this->HeightMap->GetClassName() << " has no samples.");
    return false;
  }
  return true;
}

void vtkDisplacement::GetReach(double reach[2])
{
  double range[2] = { 0.0, 0.0 };
  if (this->HeightMap && this->HeightMap->Update())
  {
    this->HeightMap->GetRange(range);
  }
  const double ends[2] = { this->Offset + this->Scale * range[0],
    this->Offset + this->Scale * range[1] };
  reach[0] = std::min(ends[0], ends[1]);
  reach[1] = std::max(ends[0], ends[1]);
}

bool vtkDisplacement::HasHoles()
{
  return this->NoDataPolicy == HOLE && this->HeightMap && this->HeightMap->HasNoData();
}

vtkMTimeType vtkDisplacement::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->HeightMap ? std::max(own, this->HeightMap->GetMTime()) : own;
}

void vtkDisplacement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightMap: " << this->HeightMap.Get() << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "Direction: ";
  if (this->AlongNormal)
  {
    os << "normal\n";
  }
  else
  {
    os << this->Direction[0] << " " << this->Direction[1] << " " << this->Direction[2] << "\n";
  }
  os << indent << "NoDataPolicy: " << (this->NoDataPolicy == HOLE ? "hole\n" : "fill\n");
}
