// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings of vtkAdaptiveCurveMapper, and what it counts.
#include "vtkAdaptiveCurveMapperInternals.h"

#include "Checks/SettingChecks.h"
#include "vtkAdaptiveRefinement.h"

#include <algorithm>

void vtkAdaptiveCurveMapper::SetMethod(int method)
{
  relevo::SetChoice(
    this, "Method", this->Method, method, { "INSTANCING", "HARDWARE_TESSELLATION" });
}

void vtkAdaptiveCurveMapper::SetRepresentation(int representation)
{
  relevo::SetChoice(
    this, "Representation", this->Representation, representation, { "LINES", "RIBBONS", "TUBES" });
}

void vtkAdaptiveCurveMapper::SetRadius(double radius)
{
  relevo::SetInRange(this, "Radius", this->Radius, radius, 0.0, relevo::LargestDouble);
}

void vtkAdaptiveCurveMapper::SetRadiusArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->RadiusArrayName != text)
  {
    this->RadiusArrayName = text;
    this->Modified();
  }
}

void vtkAdaptiveCurveMapper::SetNumberOfSides(int sides)
{
  relevo::SetInRange(this, "NumberOfSides", this->NumberOfSides, sides, 3, 64);
}

void vtkAdaptiveCurveMapper::SetFrustumCulling(bool culling)
{
  if (this->FrustumCulling != culling)
  {
    this->FrustumCulling = culling;
    this->Modified();
  }
}

//------------------------------------------------------------------------------

vtkIdType vtkAdaptiveCurveMapper::vtkInternals::Sum(const Number& getNumber) const
{
  vtkIdType sum = 0;
  for (const auto& block : this->Blocks)
  {
    sum += block.second.Painter ? getNumber(*block.second.Painter) : 0;
  }
  return sum;
}

vtkIdType vtkAdaptiveCurveMapper::vtkInternals::SumOfFrame(const Number& getNumber) const
{
  vtkIdType sum = 0;
  for (const auto& block : this->Blocks)
  {
    sum += block.second.IsDrawn ? getNumber(*block.second.Painter) : 0;
  }
  return sum;
}

int vtkAdaptiveCurveMapper::GetMethodInUse()
{
  return this->Internals->MethodInUse;
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfDrawnSegments()
{
  return this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.CountDrawnSegments(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfCulledSegments()
{
  return this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.CountHiddenSegments(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfCurves()
{
  return this->Internals->SumOfFrame(
    [](const relevo::CurvePainter& painter) { return painter.GetMesh().GetNumberOfCurves(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfCulledCurves()
{
  return this->Internals->SumOfFrame([](const relevo::CurvePainter& painter)
    { return painter.GetCurveSelection().GetNumberOfHiddenCurves(); });
}

int vtkAdaptiveCurveMapper::GetNumberOfDrawCalls()
{
  return static_cast<int>(this->Internals->SumOfFrame([](const relevo::CurvePainter& painter)
    { return static_cast<vtkIdType>(painter.GetNumberOfDrawCalls()); }));
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfSelections()
{
  return this->Internals->NumberOfSelections +
    this->Internals->Sum([](const relevo::CurvePainter& painter)
      { return painter.GetCurveSelection().GetNumberOfEvaluations(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfBufferBuilds()
{
  return this->Internals->NumberOfBufferBuilds +
    this->Internals->Sum(
      [](const relevo::CurvePainter& painter) { return painter.GetNumberOfBufferBuilds(); });
}

vtkIdType vtkAdaptiveCurveMapper::GetNumberOfShaderBuilds()
{
  return this->Internals->NumberOfShaderBuilds +
    this->Internals->Sum(
      [](const relevo::CurvePainter& painter) { return painter.GetNumberOfShaderBuilds(); });
}

vtkTypeInt64 vtkAdaptiveCurveMapper::GetGraphicsMemorySize()
{
  return this->Internals->Sum([](const relevo::CurvePainter& painter)
    { return static_cast<vtkIdType>(painter.GetMemorySize()); });
}

vtkMTimeType vtkAdaptiveCurveMapper::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Refinement ? std::max(time, this->Refinement->GetMTime()) : time;
}

void vtkAdaptiveCurveMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkAdaptiveCurveMapper* other = vtkAdaptiveCurveMapper::SafeDownCast(mapper))
  {
    this->SetRefinement(other->Refinement);
    this->SetMethod(other->Method);
    this->SetRepresentation(other->Representation);
    this->SetRadius(other->Radius);
    this->SetRadiusArrayName(other->GetRadiusArrayName());
    this->SetNumberOfSides(other->NumberOfSides);
    this->SetFrustumCulling(other->FrustumCulling);
    this->SetInputConnection(other->GetInputConnection(0, 0));
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkAdaptiveCurveMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Representation: " << this->Representation << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "NumberOfSides: " << this->NumberOfSides << "\n";
  os << indent << "FrustumCulling: " << this->FrustumCulling << "\n";
}
