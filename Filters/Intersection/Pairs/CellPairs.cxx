// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs/CellPairs.h"

#include "Mesh/MovedSurface.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <utility>

namespace relevo
{
void AddCellPairs(const MovedSurface& first, const MovedSurface& second,
  const std::vector<IntersectingPair>& pairs, vtkFieldData* data)
{
  const bool isSelf = &first == &second;
  std::vector<std::pair<vtkIdType, vtkIdType>> cells;
  cells.reserve(pairs.size());
  for (const IntersectingPair& pair : pairs)
  {
    const vtkIdType a = first.GetCell(pair.Triangles[0]);
    const vtkIdType b = second.GetCell(pair.Triangles[1]);
    cells.emplace_back(isSelf ? std::min(a, b) : a, isSelf ? std::max(a, b) : b);
  }
  vtkSMPTools::Sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  vtkNew<vtkIdTypeArray> ids[2];
  ids[0]->SetName("AllInput0CellID");
  ids[1]->SetName("AllInput1CellID");
  for (const auto& side : ids)
  {
    side->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
    data->AddArray(side);
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    ids[0]->SetValue(static_cast<vtkIdType>(i), cells[i].first);
    ids[1]->SetValue(static_cast<vtkIdType>(i), cells[i].second);
  }
}
}
