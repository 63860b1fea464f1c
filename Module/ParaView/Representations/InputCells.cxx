// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "InputCells.h"

#include "Composite/DataLeaves.h"
#include "Parallel/ProcessReduction.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <vector>

namespace relevo
{
namespace
{
template <typename Set, typename Number>
double SumOverLeaves(vtkDataObject* data, const Number& getNumber)
{
  double sum = 0.0;
  for (const DataLeaf& leaf : FindDataLeaves(data))
  {
    auto set = Set::SafeDownCast(leaf.Data);
    sum += set ? static_cast<double>(getNumber(set)) : 0.0;
  }
  return sum;
}
}

double CountFaces(vtkDataObject* tree)
{
  return SumOverLeaves<vtkPolyData>(
    tree, [](vtkPolyData* mesh) { return mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips(); });
}

double CountLines(vtkDataObject* tree)
{
  return SumOverLeaves<vtkPolyData>(
    tree, [](vtkPolyData* mesh) { return mesh->GetNumberOfLines(); });
}

bool HasCellsButNone(
  vtkDataObject* input, double numberOfDrawnCells, vtkMultiProcessController* controller)
{
  const double ofInput =
    SumOverLeaves<vtkDataSet>(input, [](vtkDataSet* data) { return data->GetNumberOfCells(); });
  std::vector<double> numbers{ ofInput, numberOfDrawnCells };
  const bool hasProcesses = controller && controller->GetNumberOfProcesses() > 1;
  if (hasProcesses)
  {
    ProcessReduction(controller).Add(numbers);
  }
  const bool isFirst = !hasProcesses || controller->GetLocalProcessId() == 0;
  return isFirst && numbers[0] > 0.0 && numbers[1] == 0.0;
}
}
