// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellFetcher
 * @brief   safe access to the cells of a data set as vtkGenericCell
 *
 * Works around two bugs of VTK that corrupt memory:
 *
 * - A vtkGenericCell must not become a Lagrange tetrahedron of 10 points after one of 15: VTK
 *   caches tables for the latter and reads past their end.
 * - The faces of a Bézier wedge of degree 1 write weights past the end of an array. Because only
 *   points of cells and faces are used here, cells get no weights.
 *
 * Private to the module.
 */
#ifndef CellFetcher_h
#define CellFetcher_h

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace relevo
{
class CellFetcher
{
public:
  explicit CellFetcher(vtkDataSet* mesh)
    : Mesh(mesh)
  {
    if (mesh->GetPointData()->GetRationalWeights())
    {
      this->Mesh.TakeReference(mesh->NewInstance());
      this->Mesh->ShallowCopy(mesh);
      this->Mesh->GetPointData()->SetRationalWeights(nullptr);
    }
  }

  /// Returns a cell, which must be valid. The pointer is valid until the next call.
  vtkGenericCell* Fetch(vtkIdType cell)
  {
    const bool isLagrange = this->Mesh->GetCellType(cell) == VTK_LAGRANGE_TETRAHEDRON;
    vtkSmartPointer<vtkGenericCell>& fetched = isLagrange ? this->Lagrange : this->Cell;
    this->Mesh->GetCell(cell, fetched);
    if (isLagrange && fetched->GetNumberOfPoints() != this->NumberOfPoints)
    {
      this->NumberOfPoints = fetched->GetNumberOfPoints();
      fetched = vtkSmartPointer<vtkGenericCell>::New();
      this->Mesh->GetCell(cell, fetched);
    }
    return fetched;
  }

private:
  vtkSmartPointer<vtkDataSet> Mesh;
  vtkSmartPointer<vtkGenericCell> Cell = vtkSmartPointer<vtkGenericCell>::New();
  vtkSmartPointer<vtkGenericCell> Lagrange = vtkSmartPointer<vtkGenericCell>::New();
  vtkIdType NumberOfPoints = 0;
};
}

#endif
