// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings of vtkReliefMapper, and what it counts.
#include "vtkReliefMapperInternals.h"

#include "Checks/SettingChecks.h"

#include <limits>

void vtkReliefMapper::SetMethod(int method)
{
  relevo::SetChoice(
    this, "Method", this->Method, method, { "WARP", "RAY_MARCH", "REFINEMENT", "AUTOMATIC" });
}

void vtkReliefMapper::SetSearch(int search)
{
  relevo::SetChoice(this, "Search", this->Search, search,
    { "LINEAR_BINARY", "LINEAR_SECANT", "RELAXED_CONES", "MAXIMUM_MIPMAP" });
}

void vtkReliefMapper::SetShading(int shading)
{
  relevo::SetChoice(this, "Shading", this->Shading, shading, { "CAPTURED", "LIT" });
}

void vtkReliefMapper::SetSelfShadow(bool on)
{
  if (this->SelfShadow != on)
  {
    this->SelfShadow = on;
    this->Modified();
  }
}

void vtkReliefMapper::SetMaximumStretch(double stretch)
{
  relevo::SetInRange(
    this, "MaximumStretch", this->MaximumStretch, stretch, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------

vtkTypeInt64 vtkReliefMapper::GetGraphicsMemorySize()
{
  vtkTypeInt64 size = 0;
  for (relevo::ReliefPainter* painter : this->Internals->GetPainters())
  {
    size += painter->GetMemorySize();
  }
  return size;
}

int vtkReliefMapper::GetMethodInUse()
{
  return this->Internals->MethodInUse;
}

vtkIdType vtkReliefMapper::GetNumberOfWarps()
{
  vtkIdType number = this->Internals->NumberOfWarps;
  for (relevo::ReliefPainter* painter : this->Internals->GetPainters())
  {
    number += painter->GetNumberOfWarps();
  }
  return number;
}

vtkIdType vtkReliefMapper::GetNumberOfBufferBuilds()
{
  vtkIdType number = this->Internals->NumberOfBufferBuilds;
  for (relevo::ReliefPainter* painter : this->Internals->GetPainters())
  {
    number += painter->GetNumberOfBufferBuilds();
  }
  return number;
}

vtkIdType vtkReliefMapper::GetNumberOfShaderBuilds()
{
  vtkIdType number = this->Internals->NumberOfShaderBuilds;
  for (relevo::ReliefPainter* painter : this->Internals->GetPainters())
  {
    number += painter->GetNumberOfShaderBuilds();
  }
  return number;
}

void vtkReliefMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkReliefMapper* other = vtkReliefMapper::SafeDownCast(mapper))
  {
    this->SetMethod(other->Method);
    this->SetSearch(other->Search);
    this->SetShading(other->Shading);
    this->SetSelfShadow(other->SelfShadow);
    this->SetMaximumStretch(other->MaximumStretch);
    this->SetFillCracks(other->FillCracks);
    this->SetInputConnection(other->GetInputConnection(0, 0));
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkReliefMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Search: " << this->Search << "\n";
  os << indent << "Shading: " << this->Shading << "\n";
  os << indent << "SelfShadow: " << this->SelfShadow << "\n";
  os << indent << "MaximumStretch: " << this->MaximumStretch << "\n";
  os << indent << "FillCracks: " << this->FillCracks << "\n";
}
