// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/VolumeCells.h"

#include "Bezier/PiecePoints.h"
#include "Bezier/SplitCounts.h"
#include "Cells/CellChecks.h"
#include "Cells/CellReader.h"
#include "Cells/CellSplitter.h"
#include "Cells/LeftOutCells.h"
#include "Mathematics/FiniteBox.h"
#include "Mesh/CellFetcher.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Relative to a cube with the longest distance between corners. Smaller cells have no volume.
constexpr double MinimumVolume = 1e-12;
// Relative to the diagonal of the mesh, and to coordinates. Points of neighbours are at most this
// far apart.
constexpr double SamePlace = 1e-11;
constexpr double CoordinateRounding = 1e-13;
// Relative to the largest scalar.
constexpr double SameScalar = 1e-11;
constexpr size_t LatticeBatch = 1 << 10; // Bézier hexahedra

bool IsFinite(const dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

bool IsCurved(const CellKind& kind)
{
  return kind.IsSolid() && kind.Nodes != NodeKind::Corners;
}

// Returns the type of linear or quadratic cells that have the basis of a cell of any degree.
int FindSameType(const CellKind& kind, int type, const ivec3& degrees, bool isRational)
{
  const bool isLinear = kind.Nodes != NodeKind::Quadratic && degrees == ivec3(1) && !isRational;
  const bool isQuadratic = kind.Nodes == NodeKind::Lagrange && degrees == ivec3(2);
  switch (kind.Shape)
  {
    case CellTopology::Tetrahedron:
      return isLinear ? VTK_TETRA : isQuadratic ? VTK_QUADRATIC_TETRA : type;
    case CellTopology::Hexahedron:
      return isLinear ? VTK_HEXAHEDRON : type;
    case CellTopology::Wedge:
      return isLinear ? VTK_WEDGE : type;
    default:
      return type;
  }
}

// Evaluates a Bézier hexahedron at a lattice of counts + 1 points in each direction.
std::vector<BezierPoint> EvaluateLattice(const BezierHexahedron& shape, const ivec3& counts)
{
  std::vector<BezierPoint> points;
  for (int k = 0; k <= counts.z; ++k)
  {
    for (int j = 0; j <= counts.y; ++j)
    {
      for (int i = 0; i <= counts.x; ++i)
      {
        points.push_back(shape.Evaluate(dvec3(i, j, k) / dvec3(counts)));
      }
    }
  }
  return points;
}
}

// A cell of a data set.
class VolumeCells::Source
{
public:
  vtkIdType FirstPoint; // of the data set
  vtkIdType Scalars;    // of the cell, or -1 for point scalars
  bool IsGhost;
  bool HasWeights; // whether the data set has rational weights
  vtkIdType Cell;  // number of the input cell, over all data sets
};

std::vector<std::string> VolumeCells::Add(
  vtkDataSet* mesh, vtkDataArray* array, bool isOfCells, const ScalarChoice& choice)
{
  const vtkIdType firstPoint = static_cast<vtkIdType>(this->Points.size());
  const vtkIdType firstCell = static_cast<vtkIdType>(this->CellScalars.size());
  this->Points.resize(this->Points.size() + static_cast<size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, &this->Points[static_cast<size_t>(firstPoint + i)].x);
  }
  this->AddWeights(mesh);
  const std::vector<double> fillValues =
    AddScalars(array, choice, isOfCells ? this->CellScalars : this->PointScalars);
  this->NumberOfScalars =
    choice.Component == ScalarChoice::All ? array->GetNumberOfComponents() : 1;
  // Both arrays must have the same length for the following data sets.
  (isOfCells ? this->PointScalars : this->CellScalars)
    .Resize(isOfCells ? this->Points.size() : static_cast<size_t>(firstCell));

  CellDemands demands;
  demands.TakesAllTypes = true;
  demands.TakesInfinitePoints = true;
  const CellChecks checks = CheckCells(mesh, demands);
  this->Counts.AddMesh(this->NumberOfInputCells, fillValues);
  const LeftOutCells leftOut(mesh);
  CellFetcher cells(mesh);
  CellSplitter splitter;
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  vtkNew<vtkUnstructuredGrid> none;
  CellReader reader(grid ? grid : none);
  this->Cells.Prepare(static_cast<size_t>(mesh->GetNumberOfCells()));
  this->Corners.Refer(this->ReadsInPlace && grid ? grid->GetCells() : nullptr, firstPoint);
  vtkNew<vtkIdList> points;
  const bool hasWeights = mesh->GetPointData()->GetRationalWeights() != nullptr;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (checks.Uses[i] != CellUse::Solid)
    {
      continue;
    }
    const Source source = { firstPoint, isOfCells ? firstCell + i : -1, leftOut.IsGhost(i),
      hasWeights, this->NumberOfInputCells + i };
    mesh->GetCellPoints(i, points);
    if (leftOut.IsHidden(i, points) || (source.IsGhost && isOfCells) ||
      this->AddInPlace(mesh->GetCellType(i), i, points->GetNumberOfIds(), source) ||
      (grid && reader.ReadNodes(i) && this->AddCurved(reader, source)))
    {
      continue;
    }
    vtkGenericCell* cell = cells.Fetch(i);
    if (cell->GetCellDimension() == 3)
    {
      this->AddLinear(cell, source, splitter);
    }
  }
  this->NumberOfInputCells += mesh->GetNumberOfCells();
  return checks.Errors;
}

void VolumeCells::AddWeights(vtkDataSet* mesh)
{
  vtkDataArray* weights = mesh->GetPointData()->GetRationalWeights();
  const size_t first = this->Points.size() - static_cast<size_t>(mesh->GetNumberOfPoints());
  if (!weights && this->Weights.empty())
  {
    return;
  }
  this->Weights.resize(this->Points.size(), 1.0);
  for (vtkIdType i = 0; weights && i < mesh->GetNumberOfPoints(); ++i)
  {
    this->Weights[first + static_cast<size_t>(i)] = weights->GetComponent(i, 0);
  }
}

// Counts a cell that has just been added, if it is not a ghost.
void VolumeCells::Count(vtkIdType cell, bool isGhost, bool isGood, size_t before)
{
  if (!isGhost)
  {
    CellCounts::Counts& counts = this->Counts.Of(cell);
    counts.Bad += isGood ? 0 : 1;
    counts.NotFinite += this->LacksScalars ? 1 : 0;
    counts.Drawn += this->Cells.size() > before ? 1 : 0;
  }
  this->LacksScalars = false;
}

// Returns false if the cell is not curved.
bool VolumeCells::AddCurved(const CellReader& reader, const Source& source)
{
  const CellKind& kind = reader.GetKind();
  if (!IsCurved(kind))
  {
    return false;
  }
  this->Counts.Of(source.Cell).Solid += source.IsGhost ? 0 : 1;
  std::vector<vtkIdType> ids;
  for (vtkIdType node = 0; node < reader.GetNumberOfNodes(); ++node)
  {
    ids.push_back(source.FirstPoint + reader.GetNode(node));
  }
  if (!this->AreFinite(ids.data(), static_cast<vtkIdType>(ids.size())))
  {
    this->Count(source.Cell, source.IsGhost, false, this->Cells.size());
    return true;
  }
  const bool isRational = source.HasWeights && kind.Nodes == NodeKind::Bezier;
  const bool isQuadratic = kind.Nodes == NodeKind::Quadratic;
  const ivec3 degrees = isQuadratic ? ivec3(0) : reader.GetDegrees();
  const int type = FindSameType(kind, reader.GetType(), degrees, isRational);
  if (GetCellKind(type, reader.GetNumberOfNodes()).Nodes == NodeKind::Corners)
  {
    const size_t before = this->Cells.size();
    const bool isGood = this->AddWhole(type, ids, source);
    this->Count(source.Cell, source.IsGhost, isGood, before);
    return true;
  }
  this->Curved.Add(
    { { type, type == VTK_QUADRATIC_TETRA ? ivec3(0) : degrees, reader.GetNumberOfNodes(), false },
      0, source.Scalars, source.IsGhost, isRational, source.Cell },
    ids);
  return true;
}

// Adds a cell with a CellShape, or a tetrahedron.
bool VolumeCells::AddWhole(int type, const std::vector<vtkIdType>& ids, const Source& source)
{
  const CellShape* shape = FindCellShape(type);
  std::vector<vtkIdType> corners;
  for (size_t i = 0; i < ids.size(); ++i)
  {
    corners.push_back(ids[static_cast<size_t>(GetCorner(type, static_cast<int>(i)))]);
  }
  if (!shape || !this->SplitsAll)
  {
    return this->AddCell(
      shape, corners, source.Scalars, source.Cell, source.IsGhost ? this->Ghosts : this->Cells);
  }
  CellSplitter splitter;
  bool isGood = false;
  const std::vector<vtkIdType> split = splitter.Split(type, ids, this->Points.data());
  for (size_t first = 0; first + 4 <= split.size(); first += 4)
  {
    isGood |= this->AddCell(nullptr, { split.begin() + first, split.begin() + first + 4 },
      source.Scalars, source.Cell, source.IsGhost ? this->Ghosts : this->Cells);
  }
  return isGood;
}

// Returns false if the cell must be copied or split.
bool VolumeCells::AddInPlace(int type, vtkIdType number, vtkIdType count, const Source& source)
{
  const CellShape* shape = FindCellShape(type);
  const bool isWhole =
    type == VTK_TETRA || (shape && type != VTK_VOXEL && type != VTK_QUADRATIC_TETRA);
  const std::uint64_t address =
    isWhole && !(shape && this->SplitsAll) ? this->Corners.Find(number) : CornerIds::NoAddress;
  if (address == CornerIds::NoAddress || count != (shape ? shape->NumberOfCorners : 4))
  {
    return false;
  }
  this->Counts.Of(source.Cell).Solid += source.IsGhost ? 0 : 1;
  const size_t before = this->Cells.size();
  const bool isGood = this->Accept(
    { shape, address, source.Scalars }, source.Cell, source.IsGhost ? this->Ghosts : this->Cells);
  this->Count(source.Cell, source.IsGhost, isGood, before);
  return true;
}

void VolumeCells::AddLinear(vtkGenericCell* cell, const Source& source, CellSplitter& splitter)
{
  std::vector<vtkIdType> ids(cell->GetPointIds()->begin(), cell->GetPointIds()->end());
  for (vtkIdType& id : ids)
  {
    id += source.FirstPoint;
  }
  this->Counts.Of(source.Cell).Solid += source.IsGhost ? 0 : 1;
  const size_t before = this->Cells.size();
  bool isGood = false;
  if (this->AreFinite(ids.data(), static_cast<vtkIdType>(ids.size())))
  {
    const int type = cell->GetCellType();
    if (type == VTK_TETRA || FindCellShape(type))
    {
      isGood = this->AddWhole(type, ids, source);
    }
    else
    {
      const std::vector<vtkIdType>& split =
        splitter.Split(cell, &this->Points[static_cast<size_t>(source.FirstPoint)]);
      std::vector<vtkIdType> corners(4);
      for (size_t first = 0; first + 4 <= split.size(); first += 4)
      {
        std::transform(split.begin() + first, split.begin() + first + 4, corners.begin(),
          [&](vtkIdType id) { return source.FirstPoint + id; });
        isGood |= this->AddCell(nullptr, corners, source.Scalars, source.Cell,
          source.IsGhost ? this->Ghosts : this->Cells);
      }
    }
  }
  this->Count(source.Cell, source.IsGhost, isGood, before);
}

void VolumeCells::ConvertCurved()
{
  if (!this->SplitsAll && this->Curved.AreQuadraticTetrahedra())
  {
    for (const CurvedCells::Cell& cell : this->Curved.GetCells())
    {
      const vtkIdType* nodes = this->Curved.GetNodes(cell);
      const size_t before = this->Cells.size();
      const bool isGood = this->AddCell(FindCellShape(VTK_QUADRATIC_TETRA),
        { nodes, nodes + cell.Type.NumberOfNodes }, cell.Scalars, cell.Source,
        cell.IsGhost ? this->Ghosts : this->Cells);
      this->Count(cell.Source, cell.IsGhost, isGood, before);
      if (!cell.IsGhost && this->Cells.size() > before)
      {
        this->Counts.Of(cell.Source).Folded +=
          this->GetCurved(this->Cells.back()).IsFolded() ? 1 : 0;
      }
    }
    this->Curved.Clear();
    return;
  }
  this->Curved.Convert({ this->Points, this->PointScalars, this->CellScalars, this->Weights },
    this->NumberOfScalars, this->Counts);
}

bool VolumeCells::SplitCurved(const SplitTolerances& tolerances)
{
  std::vector<CurvedPart> parts = std::move(this->Curved.GetParts());
  this->Curved.GetParts().clear();
  FiniteBox box;
  Scalars same = {};
  double largest = 0.0;
  for (const CurvedPart& part : parts)
  {
    dvec3 low;
    dvec3 high;
    part.Shape.FindBounds(low, high);
    box.Add(&low.x);
    box.Add(&high.x);
    largest = std::max({ largest, length(low), length(high) });
    for (int c = 0; c < part.Shape.GetNumberOfScalars(); ++c)
    {
      double least;
      double most;
      part.Shape.FindRange(c, least, most);
      same[c] = std::max({ same[c], SameScalar * std::abs(least), SameScalar * std::abs(most) });
    }
  }
  const double diagonal = length(dvec3(box.GetSide(0), box.GetSide(1), box.GetSide(2)));
  PlaceSet places(SamePlace * diagonal + CoordinateRounding * largest);
  PiecePoints points(places, same, this->Points, this->PointScalars);
  for (const Cell& cell : this->Cells)
  {
    for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
    {
      points.Reuse(this->GetCornerId(cell, i));
    }
  }
  const SplitCounts counts(parts, tolerances, places);
  CellSplitter splitter;
  std::vector<std::vector<BezierPoint>> lattices(std::min(LatticeBatch, parts.size()));
  for (size_t begin = 0; begin < parts.size(); begin += LatticeBatch)
  {
    const size_t count = std::min(LatticeBatch, parts.size() - begin);
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          lattices[i] = EvaluateLattice(parts[begin + i].Shape, counts.Get(begin + i));
        }
      });
    for (size_t i = 0; i < count; ++i)
    {
      this->AddPieces(parts[begin + i], counts.Get(begin + i), points, lattices[i], splitter);
    }
  }
  return !counts.AreLimited();
}

void VolumeCells::AddPieces(const CurvedPart& part, const ivec3& counts, PiecePoints& points,
  const std::vector<BezierPoint>& lattice, CellSplitter& splitter)
{
  const ivec3 size = counts + 1;
  std::vector<vtkIdType> ids(lattice.size());
  for (size_t at = 0; at < lattice.size(); ++at)
  {
    const int i = static_cast<int>(at);
    const ivec3 step(i % size.x, i / size.x % size.y, i / size.x / size.y);
    const bool isInner = all(greaterThan(step, ivec3(0))) && all(lessThan(step, counts));
    ids[at] = isInner ? points.Add(lattice[at]) : points.Find(lattice[at]);
  }
  std::vector<vtkIdType> corners;
  for (int i = 0; i < counts.x * counts.y * counts.z; ++i)
  {
    const ivec3 step(i % counts.x, i / counts.x % counts.y, i / counts.x / counts.y);
    corners.clear();
    for (int corner = 0; corner < 8; ++corner)
    {
      const ivec3 at = step + ivec3((corner + 1) >> 1 & 1, corner >> 1 & 1, corner >> 2);
      corners.push_back(ids[static_cast<size_t>(at.x + size.x * (at.y + size.y * at.z))]);
    }
    this->AddPiece(corners, part, splitter);
  }
}

void VolumeCells::AddPiece(
  std::vector<vtkIdType>& corners, const CurvedPart& part, CellSplitter& splitter)
{
  const bool isPyramid = std::all_of(
    corners.begin() + 4, corners.end(), [&](vtkIdType corner) { return corner == corners[4]; });
  corners.resize(isPyramid ? 5 : 8);
  const int type = isPyramid ? VTK_PYRAMID : VTK_HEXAHEDRON;
  VolumeCellList& all = part.IsGhost ? this->Ghosts : this->Cells;
  if (!this->SplitsAll)
  {
    this->AddCell(FindCellShape(type), corners, part.Scalars, part.Source, all);
    return;
  }
  const std::vector<vtkIdType>& split = splitter.Split(type, corners, this->Points.data());
  for (size_t first = 0; first + 4 <= split.size(); first += 4)
  {
    this->AddCell(nullptr, { split.begin() + first, split.begin() + first + 4 }, part.Scalars,
      part.Source, all);
  }
}

// VTK's functions that split cells do not terminate if coordinates are NaN.
bool VolumeCells::AreFinite(const vtkIdType* points, vtkIdType count) const
{
  return std::all_of(
    points, points + count, [&](vtkIdType point) { return IsFinite(this->Points[point]); });
}

vtkIdType VolumeCells::GetSource(size_t number) const
{
  return number < this->Cells.size() ? this->Sources[number]
                                     : this->GetCurvedParts()[number - this->Cells.size()].Source;
}

bool VolumeCells::HasCellScalars() const
{
  return !this->Cells.empty() ? this->Cells.front().Scalars >= 0
                              : this->HasCurvedParts() && this->GetCurvedParts()[0].Scalars >= 0;
}

int VolumeCells::GetNumberOfCorners(const Cell& cell) const
{
  return cell.Shape ? cell.Shape->NumberOfCorners : 4;
}

vtkIdType VolumeCells::GetCornerId(const Cell& cell, int i) const
{
  return this->Corners.Get(cell.FirstCorner, i);
}

void VolumeCells::GetRange(int component, double& low, double& high) const
{
  low = std::numeric_limits<double>::max();
  high = -low;
  const auto add = [&](const Scalars& scalars)
  {
    low = std::min(low, scalars[component]);
    high = std::max(high, scalars[component]);
  };
  for (const Cell& cell : this->Cells)
  {
    if (cell.Scalars >= 0)
    {
      add(this->CellScalars[cell.Scalars]);
    }
    for (int i = 0; i < this->GetNumberOfCorners(cell) && cell.Scalars < 0; ++i)
    {
      add(this->PointScalars[this->GetCornerId(cell, i)]);
    }
  }
  const std::vector<CurvedPart>& parts = this->GetCurvedParts();
  std::vector<std::array<double, 2>> ranges(parts.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (size_t i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i)
      {
        const CurvedPart& part = parts[i];
        if (part.Scalars < 0 && component < part.Shape.GetNumberOfScalars())
        {
          part.Shape.FindRange(component, ranges[i][0], ranges[i][1]);
        }
        else
        {
          ranges[i].fill(part.Scalars < 0 ? 0.0 : this->CellScalars[part.Scalars][component]);
        }
      }
    });
  for (const auto& range : ranges)
  {
    low = std::min(low, range[0]);
    high = std::max(high, range[1]);
  }
}

TetrahedronCorners VolumeCells::GetTetrahedron(const Cell& cell) const
{
  TetrahedronCorners corners;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = this->Points[this->GetCornerId(cell, i)];
  }
  return corners;
}

CurvedCell VolumeCells::GetCurved(const Cell& cell) const
{
  CurvedCell curved(*cell.Shape);
  for (int i = 0; i < cell.Shape->NumberOfCorners; ++i)
  {
    curved.SetCorner(i, this->Points[this->GetCornerId(cell, i)]);
  }
  return curved;
}

// Returns whether the cell has a volume.
bool VolumeCells::AddCell(const CellShape* shape, const std::vector<vtkIdType>& corners,
  vtkIdType scalars, vtkIdType source, VolumeCellList& all)
{
  const Cell cell = { shape, this->Corners.Append(corners), scalars };
  const size_t before = all.size();
  const bool hasVolume = this->Accept(cell, source, all);
  if (all.size() == before)
  {
    this->Corners.RemoveFrom(cell.FirstCorner);
  }
  return hasVolume;
}

// Returns whether the cell has a volume. Cells with scalars that are not finite are transparent and
// are not stored.
bool VolumeCells::Accept(const Cell& cell, vtkIdType source, VolumeCellList& all)
{
  const bool hasVolume = this->HasVolume(cell);
  const bool hasScalars = this->HasScalars(cell);
  this->LacksScalars = this->LacksScalars || (hasVolume && !hasScalars);
  if (hasVolume && hasScalars)
  {
    all.push_back(cell);
    if (this->KeepsSources && &all == &this->Cells)
    {
      this->Sources.push_back(source);
    }
  }
  return hasVolume;
}

bool VolumeCells::HasVolume(const Cell& cell) const
{
  double longest = 0.0;
  for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
  {
    const dvec3& point = this->Points[this->GetCornerId(cell, i)];
    if (!IsFinite(point))
    {
      return false;
    }
    for (int j = 0; j < i; ++j)
    {
      longest = std::max(longest, distance(point, this->Points[this->GetCornerId(cell, j)]));
    }
  }
  const double volume = cell.Shape ? this->GetCurved(cell).ComputeVolume()
                                   : ComputeSixfoldVolume(this->GetTetrahedron(cell));
  return volume > MinimumVolume * longest * longest * longest;
}

bool VolumeCells::HasScalars(const Cell& cell) const
{
  if (cell.Scalars >= 0)
  {
    return IsFinite(this->CellScalars[cell.Scalars]);
  }
  for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
  {
    if (!IsFinite(this->PointScalars[this->GetCornerId(cell, i)]))
    {
      return false;
    }
  }
  return true;
}

// Uses differences, so that the gradient of constant scalars is exactly 0.
Gradients VolumeCells::ComputeGradients(
  const Cell& cell, const CornerSlopes& slopes, int numberOfComponents) const
{
  Gradients gradients = {};
  const Scalars first = this->PointScalars[this->GetCornerId(cell, 0)];
  for (int i = 1; i < this->GetNumberOfCorners(cell); ++i)
  {
    const Scalars scalars = this->PointScalars[this->GetCornerId(cell, i)];
    for (int c = 0; c < numberOfComponents; ++c)
    {
      gradients[c] += (scalars[c] - first[c]) * slopes[i];
    }
  }
  return gradients;
}

void VolumeCells::MoveToOrigin()
{
  FiniteBox box;
  for (const Cell& cell : this->Cells)
  {
    for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
    {
      box.Add(&this->Points[this->GetCornerId(cell, i)].x);
    }
  }
  for (const CurvedPart& part : this->GetCurvedParts())
  {
    dvec3 low;
    dvec3 high;
    part.Shape.FindBounds(low, high);
    box.Add(&low.x);
    box.Add(&high.x);
  }
  this->Middle = dvec3(box.GetMiddle(0), box.GetMiddle(1), box.GetMiddle(2));
  this->Diagonal = length(dvec3(box.GetSide(0), box.GetSide(1), box.GetSide(2)));
  for (dvec3& point : this->Points)
  {
    point -= this->Middle;
  }
  for (CurvedPart& part : this->Curved.GetParts())
  {
    part.Shape.Move(-this->Middle);
  }
}
}
