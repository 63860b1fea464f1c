// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks/MisplacedArray.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

namespace relevo
{
namespace
{
constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
}

std::string AdviseConversion(int association)
{
  return association == Cells ? "Convert it with vtkCellDataToPointData"
                              : "Convert it with vtkPointDataToCellData";
}

ArrayAdvice AdviseInputArray(const std::string& name)
{
  return [name](int association)
  {
    return std::string("Use SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_") +
      (association == Cells ? "CELLS" : "POINTS") + ", \"" + name + "\")";
  };
}

std::string DescribeMisplacedArray(
  vtkDataSet* data, const std::string& name, int association, const ArrayAdvice& advise)
{
  if (!data || name.empty() || (association != Points && association != Cells))
  {
    return "";
  }
  const bool isOfPoints = data->GetPointData()->GetArray(name.c_str()) != nullptr;
  const bool isOfCells = data->GetCellData()->GetArray(name.c_str()) != nullptr;
  if (association == Points ? !isOfCells || isOfPoints : !isOfPoints || isOfCells)
  {
    return "";
  }
  const std::string advice = advise(association == Points ? Cells : Points);
  return (association == Points ? "no point array \"" : "no cell array \"") + name +
    (association == Points ? "\", but a cell array of that name"
                           : "\", but a point array of that name") +
    (advice.empty() ? "" : ". " + advice);
}
}
