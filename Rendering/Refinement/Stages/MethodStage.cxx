// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/MethodStage.h"

#include "Checks/ShouldReport.h"
#include "Methods/MethodFactory.h"

namespace relevo
{
MethodStage::MethodStage() = default;
MethodStage::~MethodStage() = default;

RefinementMethod& MethodStage::Get()
{
  std::unique_ptr<RefinementMethod>& method = this->Methods[this->InUse];
  if (!method)
  {
    method = NewMethod(this->InUse);
  }
  return *method;
}

StageResult MethodStage::Choose(const Input& input)
{
  this->Wanted = input.Method;
  this->InUse = input.Method;
  const RefinementMethod& method = this->Get();
  std::string error = method.GetMissing();
  error = error.empty() ? method.FindError(*input.Family)
                        : "it needs " + error + ", which this OpenGL context does not have";
  StageResult result;
  if (ShouldReport(this->Error, error))
  {
    result.Errors.push_back(this->DescribeUnavailable(error));
  }
  if (!error.empty() || input.HasFailedShaders || !method.CanDraw(input.Faces) ||
    (input.HasVertices && !method.CanDraw(Primitives::POINTS)))
  {
    this->FallBackToDefaultMethod();
  }
  return result;
}

std::string MethodStage::DescribeUnavailable(const std::string& error) const
{
  return std::string("The method ") + RefinementMethod::GetName(this->Wanted) +
    " cannot be used: " + error + ". The method ARKFPI is used instead.";
}

std::vector<int> MethodStage::ReleaseUnused(vtkWindow* window)
{
  std::vector<int> released;
  for (auto& method : this->Methods)
  {
    if (method.first != this->Wanted && method.first != this->InUse)
    {
      method.second->ReleaseGraphicsResources(window);
      released.push_back(method.first);
    }
  }
  return released;
}

vtkTypeInt64 MethodStage::GetMemorySize() const
{
  vtkTypeInt64 sum = 0;
  for (const auto& method : this->Methods)
  {
    sum += method.second->GetMemorySize();
  }
  return sum;
}

void MethodStage::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& method : this->Methods)
  {
    method.second->ReleaseGraphicsResources(window);
  }
  this->Error.clear();
}
}
