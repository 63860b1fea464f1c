// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/CurvedCells.h"

#include "Bezier/DeterminantSigns.h"
#include "Cells/CellKind.h"
#include "vtkCellType.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <utility>

namespace relevo
{
namespace
{
constexpr size_t BatchSize = 1 << 12; // cells
// Relative to a cube with the diagonal of the cell's box. Smaller cells have no volume.
constexpr double MinimumVolume = 1e-12;
}

// The extreme Jacobian determinants at samples of cells.
struct CurvedCells::Jacobians
{
  double Low = 0.0;
  double High = 0.0;
  double Cube = 0.0; // volume of a cube with the same diagonal

  Jacobians() = default;
  explicit Jacobians(const std::vector<BezierHexahedron>& parts)
  {
    for (const BezierHexahedron& part : parts)
    {
      dvec3 low;
      dvec3 high;
      part.FindBounds(low, high);
      const double side = length(high - low);
      this->Cube = std::max(this->Cube, side * side * side);
      for (int i = 0; i < BezierHexahedron::NumberOfSamples; ++i)
      {
        this->Add(determinant(part.Derive(BezierHexahedron::GetSample(i))));
      }
      for (int i = 0; i < 8; ++i)
      {
        this->Add(determinant(part.Derive(dvec3(i & 1, i >> 1 & 1, i >> 2))));
      }
    }
  }
  void Add(double here)
  {
    this->Low = std::min(this->Low, here);
    this->High = std::max(this->High, here);
  }
  bool HasVolume() const { return std::max(-this->Low, this->High) > MinimumVolume * this->Cube; }
  bool IsFolded() const { return HasBothSigns(this->Low, this->High); }
};

namespace
{
CellTopology GetShape(const CurvedCells::Cell& cell)
{
  return GetCellKind(cell.Type.Type, cell.Type.NumberOfNodes).Shape;
}
}

void CurvedCells::Add(Cell cell, const std::vector<vtkIdType>& nodes)
{
  cell.FirstNode = this->Nodes.size();
  this->Cells.push_back(cell);
  this->Nodes.insert(this->Nodes.end(), nodes.begin(), nodes.end());
}

bool CurvedCells::AreQuadraticTetrahedra() const
{
  return std::all_of(this->Cells.begin(), this->Cells.end(),
    [](const Cell& cell) { return cell.Type.Type == VTK_QUADRATIC_TETRA; });
}

void CurvedCells::Clear()
{
  this->Cells.clear();
  this->Cells.shrink_to_fit();
  this->Nodes.clear();
  this->Nodes.shrink_to_fit();
}

bool CurvedCells::HasScalars(const Cell& cell, const Points& points) const
{
  if (cell.Scalars >= 0)
  {
    return IsFinite(points.CellValues[cell.Scalars]);
  }
  const vtkIdType* nodes = this->GetNodes(cell);
  return std::all_of(nodes, nodes + cell.Type.NumberOfNodes,
    [&](vtkIdType node) { return IsFinite(points.Values[node]); });
}

std::vector<BezierHexahedron> CurvedCells::Convert(const Cell& cell,
  const CurvedCellConversion& conversion, const Points& points, int numberOfScalars) const
{
  if (!this->HasScalars(cell, points))
  {
    return {};
  }
  CurvedCellType type = cell.Type;
  type.IsHalved = this->IsHalved;
  std::vector<CurvedNode> nodes;
  for (vtkIdType i = 0; i < type.NumberOfNodes; ++i)
  {
    const vtkIdType node = this->GetNodes(cell)[i];
    nodes.push_back({ points.Positions[node], cell.IsRational ? points.Weights[node] : 1.0,
      points.Values[node] });
  }
  return conversion.Convert(type, nodes, cell.Scalars < 0 ? numberOfScalars : 0);
}

void CurvedCells::AddParts(const Cell& cell, std::vector<BezierHexahedron>&& parts,
  const Jacobians& jacobians, CellCounts::Counts& counts)
{
  if (parts.empty())
  {
    return;
  }
  if (!cell.IsGhost)
  {
    counts.Bad += jacobians.HasVolume() ? 0 : 1;
    counts.Drawn += jacobians.HasVolume() ? 1 : 0;
    counts.Folded += jacobians.HasVolume() && jacobians.IsFolded() ? 1 : 0;
  }
  if (jacobians.HasVolume())
  {
    for (BezierHexahedron& part : parts)
    {
      this->Parts.push_back({ std::move(part), cell.Scalars, cell.IsGhost, cell.Source });
    }
  }
}

void CurvedCells::Convert(const Points& points, int numberOfScalars, CellCounts& counts)
{
  std::array<bool, 2> has = {}; // hexahedra or pyramids; tetrahedra or wedges
  bool hasWedges = false;
  bool hasTetrahedra = false;
  for (const Cell& cell : this->Cells)
  {
    const CellTopology shape = GetShape(cell);
    hasWedges = hasWedges || shape == CellTopology::Wedge;
    hasTetrahedra = hasTetrahedra || shape == CellTopology::Tetrahedron;
    has[shape == CellTopology::Wedge || shape == CellTopology::Tetrahedron ? 1 : 0] = true;
  }
  this->IsHalved = (has[0] && has[1]) || (hasWedges && hasTetrahedra);
  CurvedCellConversion conversion;
  for (const Cell& cell : this->Cells)
  {
    CurvedCellType type = cell.Type;
    type.IsHalved = this->IsHalved;
    const bool isGood = conversion.Prepare(type);
    if (cell.IsGhost)
    {
      continue;
    }
    CellCounts::Counts& own = counts.Of(cell.Source);
    own.Bad += isGood ? 0 : 1;
    own.NotFinite += isGood && !this->HasScalars(cell, points) ? 1 : 0;
  }
  std::vector<std::vector<BezierHexahedron>> batch(std::min(BatchSize, this->Cells.size()));
  std::vector<Jacobians> jacobians(batch.size());
  for (size_t begin = 0; begin < this->Cells.size(); begin += BatchSize)
  {
    const size_t count = std::min(BatchSize, this->Cells.size() - begin);
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          batch[i] = this->Convert(this->Cells[begin + i], conversion, points, numberOfScalars);
          jacobians[i] = Jacobians(batch[i]);
        }
      });
    for (size_t i = 0; i < count; ++i)
    {
      const Cell& cell = this->Cells[begin + i];
      this->AddParts(cell, std::move(batch[i]), jacobians[i], counts.Of(cell.Source));
    }
  }
  this->Clear();
}
}
