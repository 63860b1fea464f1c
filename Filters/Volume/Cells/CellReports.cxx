// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellReports.h"

#include "Cells/MeshScalars.h"
#include "Mesh/CellCounts.h"
#include "vtkDataArray.h"

namespace relevo
{
namespace
{
using Count = vtkIdType CellCounts::Counts::*;

// Returns "3 of 8 cells SAY, in Block 1, Block 2 and 4 more blocks", without an end.
std::string CountCells(const CellCounts& counts, const std::vector<MeshScalars>& meshes,
  Count count, const std::string& say)
{
  constexpr int maximumNamed = 5;
  std::string blocks;
  int affected = 0;
  for (std::size_t i = 0; i < counts.GetNumberOfMeshes(); ++i)
  {
    if (counts.GetMesh(i).*count == 0 || meshes[i].Block.empty())
    {
      continue;
    }
    if (++affected <= maximumNamed)
    {
      blocks += (blocks.empty() ? ", in " : ", ") + meshes[i].Block;
    }
  }
  if (affected > maximumNamed)
  {
    const int more = affected - maximumNamed;
    blocks += " and " + std::to_string(more) + (more == 1 ? " more block" : " more blocks");
  }
  const CellCounts::Counts sum = counts.GetSum();
  return std::to_string(sum.*count) + " of " + std::to_string(sum.Solid) + " cells " + say + blocks;
}
}

std::vector<std::string> DescribeBadCells(
  const CellCounts& counts, const std::vector<MeshScalars>& meshes)
{
  const CellCounts::Counts sum = counts.GetSum();
  std::vector<std::string> warnings;
  if (sum.Bad > 0)
  {
    warnings.push_back(CountCells(counts, meshes, &CellCounts::Counts::Bad,
                         "have no volume, or points that are not finite") +
      "; they are left out.");
  }
  if (sum.Folded > 0)
  {
    warnings.push_back(CountCells(counts, meshes, &CellCounts::Counts::Folded,
                         "are tangled: their nodes turn them inside out in some places") +
      ". They are drawn, but values are ambiguous there.");
  }
  return warnings;
}

std::string DescribeMissingValues(const CellCounts& counts, const std::vector<MeshScalars>& meshes)
{
  if (counts.GetSum().NotFinite == 0)
  {
    return "";
  }
  const char* name = meshes.front().Array->GetName();
  const std::string array = name ? "array \"" + std::string(name) + "\"" : "active scalars";
  return CountCells(counts, meshes, &CellCounts::Counts::NotFinite,
           "have values of the " + array + " that are not finite") +
    "; they are transparent.";
}
}
