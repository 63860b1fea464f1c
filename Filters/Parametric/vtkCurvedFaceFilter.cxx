// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCurvedFaceFilter.h"

#include "Arrays/CellDataCopy.h"
#include "Arrays/SimilarArray.h"
#include "Cells/CellChecks.h"
#include "Cells/FaceCells.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCurvedFaceFilter);

namespace
{
bool HasDegrees(const relevo::FaceCell& cell)
{
  return cell.Type == VTK_LAGRANGE_TRIANGLE || cell.Type == VTK_LAGRANGE_QUADRILATERAL ||
    cell.Type == VTK_BEZIER_TRIANGLE || cell.Type == VTK_BEZIER_QUADRILATERAL;
}

// Return the new id of each point of the grid, or -1, and list the points that are kept.
std::vector<vtkIdType> NumberPoints(
  const std::vector<relevo::FaceCell>& cells, vtkIdType numberOfPoints, vtkIdList* kept)
{
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(numberOfPoints), -1);
  for (const relevo::FaceCell& cell : cells)
  {
    for (vtkIdType point : cell.Points)
    {
      numbers[static_cast<std::size_t>(point)] = 0;
    }
  }
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    if (numbers[static_cast<std::size_t>(point)] == 0)
    {
      numbers[static_cast<std::size_t>(point)] = kept->InsertNextId(point);
    }
  }
  return numbers;
}

// Return the names of arrays that are too short.
std::vector<std::string> StorePoints(
  vtkUnstructuredGrid* grid, vtkIdList* kept, vtkUnstructuredGrid* output)
{
  const vtkIdType number = kept->GetNumberOfIds();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->SetNumberOfPoints(number);
  grid->GetPoints()->GetData()->GetTuples(kept, points->GetData());
  output->SetPoints(points);

  std::vector<std::string> shortArrays;
  vtkPointData* from = grid->GetPointData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array->GetNumberOfTuples() < grid->GetNumberOfPoints())
    {
      shortArrays.emplace_back(array->GetName() ? array->GetName() : "");
      continue;
    }
    array->GetTuples(kept, relevo::AddArrayLike(from, array, output->GetPointData(), number));
  }
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("vtkOriginalPointIds");
  originals->SetNumberOfValues(number);
  std::copy_n(kept->GetPointer(0), number, originals->GetPointer(0));
  output->GetPointData()->AddArray(originals);
  return shortArrays;
}

void StoreCells(const std::vector<relevo::FaceCell>& cells, const std::vector<vtkIdType>& numbers,
  vtkUnstructuredGrid* output)
{
  vtkNew<vtkCellArray> connectivity;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIntArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  bool hasDegrees = false;
  for (const relevo::FaceCell& cell : cells)
  {
    connectivity->InsertNextCell(static_cast<int>(cell.Points.size()));
    for (vtkIdType point : cell.Points)
    {
      connectivity->InsertCellPoint(numbers[static_cast<std::size_t>(point)]);
    }
    types->InsertNextValue(static_cast<unsigned char>(cell.Type));
    const int tuple[3] = { cell.Degrees.x, cell.Degrees.y, 0 };
    degrees->InsertNextTypedTuple(tuple);
    hasDegrees = hasDegrees || HasDegrees(cell);
  }
  output->SetCells(types, connectivity);
  if (hasDegrees)
  {
    output->GetCellData()->SetHigherOrderDegrees(degrees);
  }
}
}

vtkCurvedFaceFilter::vtkCurvedFaceFilter() = default;

vtkCurvedFaceFilter::~vtkCurvedFaceFilter() = default;

int vtkCurvedFaceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the faces of the grid",
    [&]
    {
      return this->Extract(
        vtkUnstructuredGrid::GetData(inputVector[0]), vtkUnstructuredGrid::GetData(outputVector));
    });
}

int vtkCurvedFaceFilter::Extract(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  output->GetFieldData()->PassData(input->GetFieldData());
  if (input->GetNumberOfCells() < 1)
  {
    return 1;
  }
  const relevo::CellChecks checks = relevo::CheckCells(input);
  for (const std::string& error : checks.Errors)
  {
    vtkErrorMacro(<< error);
  }
  if (!input->GetPoints())
  {
    return 1;
  }
  const std::vector<relevo::FaceCell> cells =
    relevo::MakeFaceCells(input, relevo::FindBoundaryFaces(input, checks.Uses));
  vtkNew<vtkIdList> kept;
  const std::vector<vtkIdType> numbers = NumberPoints(cells, input->GetNumberOfPoints(), kept);
  std::vector<std::string> shortArrays = StorePoints(input, kept, output);
  vtkNew<vtkIdTypeArray> originals;
  for (const relevo::FaceCell& cell : cells)
  {
    originals->InsertNextValue(cell.Cell);
  }
  relevo::CopyCellData(input, originals, true, output->GetCellData(), shortArrays);
  StoreCells(cells, numbers, output);
  for (const std::string& name : shortArrays)
  {
    vtkWarningMacro("Array \"" << name << "\" has too few tuples and is left out.");
  }
  return 1;
}

void vtkCurvedFaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
