// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/GhostCells.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace relevo
{
namespace
{
// Cells are numbered from `first` on.
vtkSmartPointer<vtkCellArray> CopyWithoutGhosts(
  vtkCellArray* cells, vtkIdType first, const GhostCells& ghosts)
{
  auto copy = vtkSmartPointer<vtkCellArray>::New();
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    copy->InsertNextCell(ghosts.Has(first + iterator->GetCurrentCellId()) ? 0 : size, ids);
  }
  return copy;
}
}

GhostCells::GhostCells(vtkPolyData* mesh)
  : Types(vtkUnsignedCharArray::SafeDownCast(
      mesh->GetCellData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName())))
{
  if (this->Types && this->Types->GetNumberOfComponents() != 1)
  {
    this->Types = nullptr;
  }
}

bool GhostCells::AreAmong(vtkIdType first, vtkIdType end) const
{
  for (vtkIdType cell = first; this->Types && cell < end; ++cell)
  {
    if (this->Has(cell))
    {
      return true;
    }
  }
  return false;
}

bool GhostCells::Has(vtkIdType cell) const
{
  return this->Types && cell < this->Types->GetNumberOfTuples() &&
    (this->Types->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

void EmptyGhosts(vtkPolyData* input, vtkPolyData* output)
{
  const GhostCells ghosts(input);
  const vtkIdType firstLine = input->GetNumberOfVerts();
  const vtkIdType firstFace = firstLine + input->GetNumberOfLines();
  if (ghosts.AreAmong(0, firstLine))
  {
    output->SetVerts(CopyWithoutGhosts(input->GetVerts(), 0, ghosts));
  }
  if (ghosts.AreAmong(firstLine, firstFace))
  {
    output->SetLines(CopyWithoutGhosts(input->GetLines(), firstLine, ghosts));
  }
}

void EmptyGhostFaces(vtkPolyData* input, vtkPolyData* output)
{
  const GhostCells ghosts(input);
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + input->GetNumberOfPolys();
  if (ghosts.AreAmong(firstPolygon, firstStrip))
  {
    output->SetPolys(CopyWithoutGhosts(input->GetPolys(), firstPolygon, ghosts));
  }
  if (ghosts.AreAmong(firstStrip, firstStrip + input->GetNumberOfStrips()))
  {
    output->SetStrips(CopyWithoutGhosts(input->GetStrips(), firstStrip, ghosts));
  }
}
}
