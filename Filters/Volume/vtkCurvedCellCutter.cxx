// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCurvedCellCutter.h"

#include "Arrays/CellDataCopy.h"
#include "Cells/CellChecks.h"
#include "Changes/LatestTime.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Sections/CellCutter.h"
#include "Sections/FieldScales.h"
#include "Sections/SectionOutput.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

vtkStandardNewMacro(vtkCurvedCellCutter);

namespace
{
std::vector<double> Evaluate(vtkDataSet* data, vtkImplicitFunction* function)
{
  std::vector<double> values(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkSMPTools::For(0, data->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        double point[3];
        data->GetPoint(i, point);
        values[i] = function->FunctionValue(point);
      }
    });
  return values;
}

std::vector<vtkIdType> FindCutCells(const std::vector<vtkIdType>& cells, vtkDataSet* data,
  vtkImplicitFunction* function, const std::vector<double>& values,
  const relevo::SectionTolerances& tolerances)
{
  std::vector<unsigned char> isCut(cells.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      relevo::CellCutter cutter(data, function, values, tolerances);
      for (vtkIdType i = first; i < end; ++i)
      {
        isCut[i] = cutter.CanCut(cells[i]);
      }
    });
  std::vector<vtkIdType> found;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (isCut[i])
    {
      found.push_back(cells[i]);
    }
  }
  return found;
}
}

vtkCurvedCellCutter::vtkCurvedCellCutter()
{
  this->SetNumberOfOutputPorts(2);
}

vtkCurvedCellCutter::~vtkCurvedCellCutter() = default;

void vtkCurvedCellCutter::SetCutFunction(vtkImplicitFunction* function)
{
  if (this->CutFunction != function)
  {
    this->CutFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkCurvedCellCutter::GetCutFunction()
{
  return this->CutFunction;
}

void vtkCurvedCellCutter::SetTolerance(double share)
{
  relevo::SetInRange(this, "Tolerance", this->Tolerance, share, 1e-7, 1.0);
}

void vtkCurvedCellCutter::SetFieldTolerance(double share)
{
  relevo::SetInRange(this, "FieldTolerance", this->FieldTolerance, share, 1e-4, 1.0);
}

vtkMTimeType vtkCurvedCellCutter::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(), { this->CutFunction });
}

int vtkCurvedCellCutter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkCurvedCellCutter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  if (!this->CutFunction)
  {
    vtkErrorMacro("There is no function to cut with; call SetCutFunction().");
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the section of the cells",
    [&]
    {
      return this->Cut(vtkDataSet::GetData(inputVector[0]), vtkPolyData::GetData(outputVector, 0),
        vtkPolyData::GetData(outputVector, 1));
    });
}

// Moving the function does not check the cells again.
void vtkCurvedCellCutter::CheckCells(vtkDataSet* input)
{
  if (input == this->CheckedInput && input->GetMTime() < this->CheckTime)
  {
    return;
  }
  const relevo::CellChecks checks = relevo::CheckCells(input);
  for (const std::string& error : checks.Errors)
  {
    vtkErrorMacro(<< error);
  }
  this->SolidCells.clear();
  for (std::size_t i = 0; i < checks.Uses.size(); ++i)
  {
    if (checks.Uses[i] == relevo::CellUse::Solid)
    {
      this->SolidCells.push_back(static_cast<vtkIdType>(i));
    }
  }
  this->CheckedInput = input;
  vtkTimeStamp now;
  now.Modified();
  this->CheckTime = now.GetMTime();
}

int vtkCurvedCellCutter::Cut(vtkDataSet* input, vtkPolyData* polygons, vtkPolyData* lines)
{
  this->CheckCells(input);
  if (this->SolidCells.empty())
  {
    return 1;
  }
  const std::vector<double> values = Evaluate(input, this->CutFunction);
  const relevo::FieldScales fields(input);
  const relevo::SectionTolerances tolerances{ this->Tolerance * input->GetLength(),
    this->FieldTolerance, fields };
  const std::vector<vtkIdType> cells =
    FindCutCells(this->SolidCells, input, this->CutFunction, values, tolerances);
  relevo::CurvedCellConversion conversion;
  relevo::CellCutter preparation(input, this->CutFunction, values, tolerances);
  for (const vtkIdType cell : cells)
  {
    preparation.Prepare(cell, conversion);
  }
  std::vector<relevo::CellSection> sections(cells.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      relevo::CellCutter cutter(input, this->CutFunction, values, tolerances);
      for (vtkIdType i = first; i < end; ++i)
      {
        sections[i] = cutter.Cut(cells[i], conversion);
      }
    });
  for (const std::string& name :
    relevo::StoreSections(sections, cells, input, this->CutFunction, polygons, lines))
  {
    vtkWarningMacro("Array \"" << name << "\" has too few tuples and is left out.");
  }
  return 1;
}

void vtkCurvedCellCutter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CutFunction: " << this->CutFunction.Get() << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "FieldTolerance: " << this->FieldTolerance << "\n";
}
