// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/CellDataCopy.h"

#include "Arrays/SimilarArray.h"
#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>

namespace relevo
{
void CopyCellData(vtkDataSet* input, vtkIdTypeArray* originals, bool keepNormals, vtkCellData* to,
  std::vector<std::string>& shortArrays)
{
  constexpr const char* name = "vtkOriginalCellIds";
  // Several new cells can have the same global id, so ids become ordinary arrays. The new cells are
  // linear and have no degrees.
  vtkNew<vtkCellData> from;
  from->ShallowCopy(input->GetCellData());
  from->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  from->SetHigherOrderDegrees(nullptr);
  if (!keepNormals)
  {
    from->SetNormals(nullptr);
  }
  from->RemoveArray(name);

  const vtkIdType numberOfCells = originals->GetNumberOfValues();
  vtkNew<vtkIdList> cells;
  if (from->GetNumberOfArrays() > 0)
  {
    cells->SetNumberOfIds(numberOfCells);
    std::copy_n(originals->GetPointer(0), numberOfCells, cells->GetPointer(0));
  }
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array->GetNumberOfTuples() < input->GetNumberOfCells())
    {
      shortArrays.emplace_back(array->GetName() ? array->GetName() : "");
      continue;
    }
    array->GetTuples(cells, AddArrayLike(from, array, to, numberOfCells));
  }
  originals->SetName(name);
  to->AddArray(originals);
}
}
