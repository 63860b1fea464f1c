// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/FilterCode.h"

#include "Code/DataCode.h"
#include "Code/ObjectCode.h"
#include "Code/RecipeCode.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkArrayQuantityFilter.h"
#include "vtkCellDataToPointData.h"
#include "vtkContourFilter.h"
#include "vtkCurvedCellCutter.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPlane.h"
#include "vtkStreamTracer.h"
#include "vtkSurfaceIntersectionFilter.h"
#include "vtkTrivialProducer.h"
#include "vtkTubeFilter.h"

#include <array>
#include <optional>

namespace
{
void AddArrayCode(SceneCode& code, const std::string& variable, vtkAlgorithm* filter)
{
  code.Call(variable, "SetInputArrayToProcess",
    { 0, 0, 0, CodeValue::Constant("vtkDataObject", "FIELD_ASSOCIATION_POINTS"),
      filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME()) });
}

std::string StartFilter(
  SceneCode& code, vtkAlgorithm* filter, const std::string& name, const CodeValue& input)
{
  const std::string variable = code.New(filter->GetClassName(), name);
  code.Call(variable, "SetInputConnection", { input });
  return variable;
}

std::string AddCutter(SceneCode& code, vtkCurvedCellCutter* cutter)
{
  code.Note("The section, with the edges of the cells.");
  const CodeValue plane = AddPlaneCode(code, vtkPlane::SafeDownCast(cutter->GetCutFunction()));
  const std::string variable =
    StartFilter(code, cutter, "cutter", AddInputCode(code, cutter, "cells"));
  code.Call(variable, "SetCutFunction", { plane });
  return variable;
}

std::string AddContours(SceneCode& code, vtkContourFilter* contours)
{
  const CodeValue input = AddInputCode(code, contours, "surface");
  const std::string variable = StartFilter(code, contours, "isolines", input);
  AddArrayCode(code, variable, contours);
  code.Call(variable, "ComputeScalarsOff");
  for (int i = 0; i < contours->GetNumberOfContours(); ++i)
  {
    code.Call(variable, "SetValue", { i, contours->GetValue(i) });
  }
  return variable;
}

std::string AddTracer(SceneCode& code, vtkStreamTracer* tracer)
{
  const CodeValue field = AddInputCode(code, tracer, "field");
  const CodeValue seeds = AddInputCode(code, tracer, "seeds", 1);
  code.Note("Streamlines from the seeds, in both directions, and tubes around them.");
  const std::string variable = StartFilter(code, tracer, "tracer", field);
  code.Call(variable, "SetSourceConnection", { seeds });
  AddArrayCode(code, variable, tracer);
  code.Call(variable, "SetIntegratorTypeToRungeKutta45");
  code.Call(variable, "SetIntegrationDirectionToBoth");
  code.Call(variable, "SetMaximumPropagation", { tracer->GetMaximumPropagation() });
  AddSetting(
    code, variable, tracer, "MaximumNumberOfSteps", &vtkStreamTracer::GetMaximumNumberOfSteps);
  code.Call(variable, "SetComputeVorticity", { CodeValue::Flag(false) });
  if (tracer->GetSurfaceStreamlines())
  {
    code.Call(variable, "SurfaceStreamlinesOn");
  }
  return variable;
}

std::string AddIntersection(SceneCode& code, vtkSurfaceIntersectionFilter* filter)
{
  using Filter = vtkSurfaceIntersectionFilter;
  const CodeValue first = AddInputCode(code, filter, "mesh", 0);
  const CodeValue second = AddInputCode(code, filter, "mesh", 1);
  std::array<std::optional<CodeValue>, 2> recipes;
  for (int i = 0; i < 2; ++i)
  {
    if (vtkAdaptiveRefinement* recipe = filter->GetRefinement(i))
    {
      recipes[static_cast<std::size_t>(i)] = AddRecipeCode(code, recipe);
    }
  }
  code.Note("The curves where the surfaces meet, and what each face touches.");
  const std::string variable = code.New("vtkSurfaceIntersectionFilter", "contact");
  code.Call(variable, "SetInputConnection", { 0, first });
  code.Call(variable, "SetInputConnection", { 1, second });
  for (int i = 0; i < 2; ++i)
  {
    if (const auto& recipe = recipes[static_cast<std::size_t>(i)])
    {
      code.Call(variable, "SetRefinement", { i, *recipe });
    }
  }
  AddSetting(code, variable, filter, "Tolerance", &Filter::GetTolerance);
  AddFlag(code, variable, filter, "JoinSegments", &Filter::GetJoinSegments);
  AddFlag(code, variable, filter, "Classify", &Filter::GetClassify);
  AddSetting(code, variable, filter, "ContactDistance", &Filter::GetContactDistance);
  return variable;
}

std::string AddTubes(SceneCode& code, vtkTubeFilter* tubes)
{
  const CodeValue lines = AddInputCode(code, tubes, "lines");
  const std::string variable = StartFilter(code, tubes, "tubes", lines);
  code.Call(variable, "SetRadius", { tubes->GetRadius() });
  AddSetting(code, variable, tubes, "NumberOfSides", &vtkTubeFilter::GetNumberOfSides);
  AddFlag(code, variable, tubes, "Capping", &vtkTubeFilter::GetCapping);
  return variable;
}

std::string AddFilterCode(SceneCode& code, vtkAlgorithm* filter)
{
  if (const auto known = code.Find(filter))
  {
    return known->Text;
  }
  std::string variable;
  if (auto* cutter = vtkCurvedCellCutter::SafeDownCast(filter))
  {
    variable = AddCutter(code, cutter);
  }
  else if (auto* contours = vtkContourFilter::SafeDownCast(filter))
  {
    variable = AddContours(code, contours);
  }
  else if (auto* tracer = vtkStreamTracer::SafeDownCast(filter))
  {
    variable = AddTracer(code, tracer);
  }
  else if (auto* tubes = vtkTubeFilter::SafeDownCast(filter))
  {
    variable = AddTubes(code, tubes);
  }
  else if (auto* contact = vtkSurfaceIntersectionFilter::SafeDownCast(filter))
  {
    variable = AddIntersection(code, contact);
  }
  else if (auto* quantity = vtkArrayQuantityFilter::SafeDownCast(filter))
  {
    variable = StartFilter(code, filter, "quantity", AddInputCode(code, filter, "data"));
    code.Call(variable, "SetQuantity", { quantity->GetQuantity() });
  }
  else if (vtkCellDataToPointData::SafeDownCast(filter))
  {
    variable = StartFilter(code, filter, "average", AddInputCode(code, filter, "data"));
  }
  else
  {
    throw ViewerError("a program cannot have a " + std::string(filter->GetClassName()));
  }
  code.Remember(filter, CodeValue::Object(variable));
  return variable;
}
}

//------------------------------------------------------------------------------
CodeValue AddInputCode(SceneCode& code, vtkAlgorithm* algorithm, const std::string& name, int port)
{
  vtkAlgorithmOutput* connection = algorithm->GetInputConnection(port, 0);
  vtkAlgorithm* producer = connection->GetProducer();
  if (!vtkTrivialProducer::SafeDownCast(producer))
  {
    return CodeValue::Port(AddFilterCode(code, producer), connection->GetIndex());
  }
  vtkDataObject* data = algorithm->GetInputDataObject(port, 0);
  if (!code.Find(data))
  {
    AddSavedDataCode(code, data, name);
  }
  return *code.Find(data);
}

//------------------------------------------------------------------------------
CodeValue AddPlaneCode(SceneCode& code, vtkPlane* plane)
{
  if (const auto known = code.Find(plane))
  {
    return *known;
  }
  const std::string variable = code.New("vtkPlane", "plane");
  const double* origin = plane->GetOrigin();
  const double* normal = plane->GetNormal();
  code.Call(variable, "SetOrigin", { origin[0], origin[1], origin[2] });
  code.Call(variable, "SetNormal", { normal[0], normal[1], normal[2] });
  code.Remember(plane, CodeValue::Object(variable));
  return CodeValue::Object(variable);
}
