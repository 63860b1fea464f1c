// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/VolumeCellList.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>

namespace relevo
{
namespace
{
constexpr int BitsOfCorner = 60;
constexpr std::uint64_t Corner = (std::uint64_t(1) << BitsOfCorner) - 1;
using Shapes = std::array<const CellShape*, 5>;

const Shapes& GetShapes()
{
  static const Shapes shapes = { { nullptr, FindCellShape(VTK_HEXAHEDRON), FindCellShape(VTK_WEDGE),
    FindCellShape(VTK_PYRAMID), FindCellShape(VTK_QUADRATIC_TETRA) } };
  return shapes;
}
}

VolumeCell VolumeCellList::operator[](size_t i) const
{
  const std::uint64_t packed = this->Packed[i];
  return { GetShapes()[packed >> BitsOfCorner], packed & Corner,
    this->ScalarsOfCells.empty() ? -1 : this->ScalarsOfCells[i] };
}

void VolumeCellList::push_back(const VolumeCell& cell)
{
  const Shapes& shapes = GetShapes();
  const auto kind = static_cast<std::uint64_t>(
    std::find(shapes.begin(), shapes.end(), cell.Shape) - shapes.begin());
  if (cell.Scalars >= 0 || !this->ScalarsOfCells.empty())
  {
    this->ScalarsOfCells.resize(this->Packed.size(), -1);
    this->ScalarsOfCells.push_back(cell.Scalars);
  }
  this->Packed.push_back(kind << BitsOfCorner | cell.FirstCorner);
}
}
