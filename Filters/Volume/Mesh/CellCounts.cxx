// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellCounts.h"

#include <algorithm>

namespace relevo
{
void CellCounts::AddMesh(vtkIdType firstCell, const std::vector<double>& fillValues)
{
  this->FirstCells.push_back(firstCell);
  this->Meshes.emplace_back();
  std::vector<double>& all = this->FillValues;
  all.insert(all.end(), fillValues.begin(), fillValues.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

CellCounts::Counts& CellCounts::Of(vtkIdType cell)
{
  const auto next = std::upper_bound(this->FirstCells.begin(), this->FirstCells.end(), cell);
  return this->Meshes[static_cast<std::size_t>(next - this->FirstCells.begin() - 1)];
}

CellCounts::Counts CellCounts::GetSum() const
{
  Counts sum;
  for (const Counts& mesh : this->Meshes)
  {
    sum.Solid += mesh.Solid;
    sum.Bad += mesh.Bad;
    sum.NotFinite += mesh.NotFinite;
    sum.Drawn += mesh.Drawn;
    sum.Folded += mesh.Folded;
  }
  return sum;
}
}
