// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellReports.h"

#include "Cells/MeshScalars.h"
#include "Mesh/CellCounts.h"
#include "vtkDataArray.h"

#include <sstream>

namespace relevo
{
namespace
{
using Count = vtkIdType CellCounts::Counts::*;

// Returns "3 of 8 cells SAY, in Block 1, Block 2 and 4 more blocks", or with SAY-ONE.
std::string CountCells(const CellCounts& counts, const std::vector<MeshScalars>& meshes,
  Count count, const std::string& sayOne, const std::string& say)
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
  return std::to_string(sum.*count) + " of " + std::to_string(sum.Solid) +
    (sum.Solid == 1 ? " cell " : " cells ") + (sum.*count == 1 ? sayOne : say) + blocks;
}

// Returns "1e+30, 9.96921e+36".
std::string ListFillValues(const std::vector<double>& values)
{
  std::ostringstream text;
  for (double value : values)
  {
    text << (value == values.front() ? "" : ", ") << value;
  }
  return text.str();
}
}

std::vector<std::string> DescribeBadCells(
  const CellCounts& counts, const std::vector<MeshScalars>& meshes)
{
  const CellCounts::Counts sum = counts.GetSum();
  std::vector<std::string> warnings;
  if (sum.Bad > 0)
  {
    const std::string lack = " no volume, or points that are not finite";
    warnings.push_back(
      CountCells(counts, meshes, &CellCounts::Counts::Bad, "has" + lack, "have" + lack) +
      (sum.Bad == 1 ? "; it is left out." : "; they are left out."));
  }
  if (sum.Folded > 0)
  {
    warnings.push_back(CountCells(counts, meshes, &CellCounts::Counts::Folded,
                         "is tangled: its nodes turn it inside out in some places",
                         "are tangled: their nodes turn them inside out in some places") +
      (sum.Folded == 1 ? ". It is" : ". They are") + " drawn, but values are ambiguous there.");
  }
  return warnings;
}

std::string DescribeMissingValues(const CellCounts& counts, const std::vector<MeshScalars>& meshes)
{
  const vtkIdType number = counts.GetSum().NotFinite;
  if (number == 0)
  {
    return "";
  }
  const char* name = meshes.front().Array->GetName();
  const std::string array = name ? "array \"" + std::string(name) + "\"" : "active scalars";
  const std::string fillValues = ListFillValues(counts.GetFillValues());
  const std::string values = " values of the " + array +
    (fillValues.empty() ? " that are not finite"
                        : " that are fill values (" + fillValues + ") or not finite");
  return CountCells(
           counts, meshes, &CellCounts::Counts::NotFinite, "has" + values, "have" + values) +
    (number == 1 ? "; it is transparent." : "; they are transparent.");
}
}
