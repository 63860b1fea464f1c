// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/TerrainBisection.h"

#include "Bisection/FaceHeights.h"
#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr int FinestLevel = BlockErrors::FinestLevel;
constexpr int Segments = TerrainFace::Segments;

// Logarithms of lengths in units of the finest lattice.
constexpr int GetBlockShift(int level)
{
  return level + 3 - FinestLevel;
}
constexpr int GetTileShift(int level)
{
  return level + 8 - FinestLevel;
}
static_assert(BlockErrors::CellsPerBlock == 1 << 3 && HeightTile::CellsPerTile == 1 << 8,
  "shifts and sizes must agree");

// Blocks up to this level are at most one sample wide, so that the ring around the cells of a tile
// contains their neighbours.
constexpr int SampleLevel = -3;

constexpr double InfiniteError = std::numeric_limits<double>::infinity();

// Errors are saturated, see BlockErrors: a bisection leaves at most this share of the error before
// it.
const double SaturationShare = std::exp2(-0.125);

// A bisection begins at the first fraction of the tolerance, and is complete at the last. Between,
// the error before it grows by (1 + 0.0905 t), where t is the morph. What the bisection leaves of
// it is at most (1 - 0.0830 t), because heights are linear in t. The product is at most 1.0019.
constexpr double FirstShare = 0.998;
const double LastShare = FirstShare / SaturationShare;

// Corners of a block, in halves of its size; a side is between its number and the next.
constexpr int Corners[4][2] = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
constexpr int SideSteps[4][2] = { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } };

// The largest error that the bisections with a tile use. The bisections of its squares are complete
// after a third of the fade, and those at their sides after half of it.
double GetVisibleError(float visibility, double tolerance)
{
  return visibility < 1.0f ? FirstShare * tolerance / std::sqrt(1.0 - visibility) : InfiniteError;
}

// The share of the error before a bisection that is left while it is not complete.
double GetRemainder(float morph)
{
  return 1.0 - morph * (1.0 - SaturationShare);
}

float MixHeights(float a, float b, float t)
{
  return std::isnan(a) || t >= 1.0f ? b : a + t * (b - a);
}

// The range of the bilinear surface of a tile of level 0 in a region; empty without data.
std::array<double, 2> FindHeights(const HeightTile& tile, const TerrainBox& region)
{
  const int first[2] = { tile.Column * HeightTile::CellsPerTile,
    tile.Row * HeightTile::CellsPerTile };
  std::array<double, 2> range = { { InfiniteError, -InfiniteError } };
  for (int row = static_cast<int>(std::floor(region.Rows[0])); row < region.Rows[1]; ++row)
  {
    for (int column = static_cast<int>(std::floor(region.Columns[0])); column < region.Columns[1];
         ++column)
    {
      const auto get = [&](int i, int j) -> double
      { return tile.GetHeight(column - first[0] + i, row - first[1] + j); };
      const double cell[2][2] = { { get(0, 0), get(1, 0) }, { get(0, 1), get(1, 1) } };
      // The surface of a part of a cell is between the heights of its corners.
      for (int corner = 0; corner < 4; ++corner)
      {
        const double u = std::clamp(region.Columns[corner % 2] - column, 0.0, 1.0);
        const double v = std::clamp(region.Rows[corner / 2] - row, 0.0, 1.0);
        const double top = cell[0][0] + u * (cell[0][1] - cell[0][0]);
        const double bottom = cell[1][0] + u * (cell[1][1] - cell[1][0]);
        const double height = top + v * (bottom - top);
        // Comparisons with NaN are false.
        range[0] = height < range[0] ? height : range[0];
        range[1] = height > range[1] ? height : range[1];
      }
    }
  }
  return range;
}

std::uint64_t GetKey(int level, std::int64_t column, std::int64_t row)
{
  return static_cast<std::uint64_t>(level - FinestLevel) << 58 |
    static_cast<std::uint64_t>(row) << 29 | static_cast<std::uint64_t>(column);
}
}

TerrainBisection::TerrainBisection(
  int columns, int rows, const BlockErrors& errors, const ElevationRanges& ranges, int period)
  : Columns(columns)
  , Rows(rows)
  , Period(period)
  , RootLevel(BlockErrors::GetRootLevel(columns, rows))
  , Errors(errors)
  , Ranges(ranges)
{
}

bool TerrainBisection::Exists(const Block& block) const
{
  const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), block.Level);
  return block.Column >= 0 && block.Row >= 0 &&
    static_cast<double>(block.Column) * size < this->Columns - 1 &&
    static_cast<double>(block.Row) * size < this->Rows - 1;
}

TerrainBox TerrainBisection::GetRegion(
  int level, const std::array<double, 2>& columns, const std::array<double, 2>& rows) const
{
  const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), level);
  TerrainBox box;
  box.Columns = { { columns[0] * size, columns[1] * size } };
  box.Rows = { { rows[0] * size, rows[1] * size } };
  // Tiles as large as a block.
  ElevationRanges::Range heights = this->Ranges.Get(level - 5, box.Columns, box.Rows);
  if (this->Period > 0 && box.Columns[1] > this->Period - 1)
  {
    const ElevationRanges::Range first =
      this->Ranges.Get(level - 5, { { 0.0, box.Columns[1] - this->Period } }, box.Rows);
    heights = { { std::min(heights[0], first[0]), std::max(heights[1], first[1]) } };
  }
  box.Heights = { { heights[0], heights[1] } };
  return box;
}

// The region contains all blocks whose bisection needs that of this one. The tile of a fine block
// must be in memory.
double TerrainBisection::ProjectSquare(const Block& block)
{
  const auto column = static_cast<double>(block.Column);
  const auto row = static_cast<double>(block.Row);
  TerrainBox region =
    this->GetRegion(block.Level, { { column - 1.0, column + 2.0 } }, { { row - 1.0, row + 2.0 } });
  if (block.Level <= SampleLevel)
  {
    region.Heights = FindHeights(this->GetTile(0, block), region);
  }
  const double error = this->Errors.GetSquareError(
    block.Level, static_cast<int>(block.Column), static_cast<int>(block.Row));
  return this->View->Project(error + this->View->GetShapeError(block.Level, true, region), region);
}

// A side belongs to the block after it.
float TerrainBisection::GetEdgeError(const Block& block, int side) const
{
  return this->Errors.GetEdgeError(block.Level,
    static_cast<int>(block.Column) + (side == 1 ? 1 : 0),
    static_cast<int>(block.Row) + (side == 2 ? 1 : 0), side % 2);
}

double TerrainBisection::ProjectEdge(const Block& block, int side)
{
  const float error = this->GetEdgeError(block, side);
  const double column = static_cast<double>(block.Column) + 0.5 * (1 + SideSteps[side][0]);
  const double row = static_cast<double>(block.Row) + 0.5 * (1 + SideSteps[side][1]);
  TerrainBox region =
    this->GetRegion(block.Level, { { column - 1.0, column + 1.0 } }, { { row - 1.0, row + 1.0 } });
  if (block.Level <= SampleLevel)
  {
    const Block other = { block.Level, block.Column + SideSteps[side][0],
      block.Row + SideSteps[side][1] };
    region.Heights = FindHeights(this->GetTile(0, this->Exists(block) ? block : other), region);
  }
  return this->View->Project(error + this->View->GetShapeError(block.Level, false, region), region);
}

float TerrainBisection::Ramp(double error) const
{
  const double first = FirstShare * this->Tolerance;
  const double last = LastShare * this->Tolerance;
  return error >= last ? 1.0f : static_cast<float>(std::max(0.0, (error - first) / (last - first)));
}

const HeightTile* TerrainBisection::FindTile(
  int level, const Block& block, double error, float& visibility)
{
  const int tileLevel = std::max(level, 0);
  const int shift = GetTileShift(tileLevel);
  const int column = static_cast<int>((block.Column << GetBlockShift(block.Level)) >> shift);
  const int row = static_cast<int>((block.Row << GetBlockShift(block.Level)) >> shift);
  const HeightTile* tile = this->Tiles->Get(tileLevel, column, row, error, visibility);
  if (!tile || visibility < 1.0f)
  {
    this->Complete = false;
  }
  return tile;
}

// The tile of a bisected block, which is in memory.
const HeightTile& TerrainBisection::GetTile(int level, const Block& block)
{
  float visibility = 1.0f;
  return *this->FindTile(level, block, 0.0, visibility);
}

// The projected error of a square, within the limits of coarser bisections and of its tile.
double TerrainBisection::LimitSquare(const Block& block)
{
  if (block.Level >= this->RootLevel)
  {
    return InfiniteError;
  }
  if (block.Level <= FinestLevel || !this->Exists(block))
  {
    return 0.0;
  }
  const std::uint64_t key = GetKey(block.Level, block.Column, block.Row);
  const auto known = this->SquareErrors.find(key);
  if (known != this->SquareErrors.end())
  {
    return known->second;
  }
  // The regions of fine blocks need the tile, which is in memory if the parent is bisected.
  const bool isFine = block.Level <= SampleLevel;
  double error = isFine ? InfiniteError : this->ProjectSquare(block);
  if (this->Ramp(error) > 0.0f)
  {
    // Its two triangles must exist. Each comes from the bisection at a side of the parent.
    const Block parent = { block.Level + 1, block.Column >> 1, block.Row >> 1 };
    const double sides = std::min(this->LimitEdge(parent, (block.Column & 1) != 0 ? 1 : 3),
      this->LimitEdge(parent, (block.Row & 1) != 0 ? 2 : 0));
    float visibility = 0.0f;
    const bool isParentBisected = this->Ramp(sides) > 0.0f;
    error = isFine && isParentBisected ? this->ProjectSquare(block) : error;
    const bool isReady =
      isParentBisected && this->FindTile(block.Level - 1, block, error, visibility) != nullptr;
    error = isReady
      ? std::min({ error, SaturationShare * sides, GetVisibleError(visibility, this->Tolerance) })
      : 0.0;
  }
  this->SquareErrors.emplace(key, error);
  return error;
}

// The same for the two triangles at a side of a split square.
double TerrainBisection::LimitEdge(const Block& block, int side)
{
  // A side belongs to the block after it.
  const std::uint64_t key =
    GetKey(block.Level, block.Column + (side == 1 ? 1 : 0), block.Row + (side == 2 ? 1 : 0)) << 1 |
    static_cast<std::uint64_t>(side % 2);
  const auto known = this->EdgeErrors.find(key);
  if (known != this->EdgeErrors.end())
  {
    return known->second;
  }
  const bool isFine = block.Level <= SampleLevel;
  double error = block.Level - 1 <= FinestLevel ? 0.0
    : isFine                                    ? InfiniteError
                                                : this->ProjectEdge(block, side);
  const Block other = { block.Level, block.Column + SideSteps[side][0],
    block.Row + SideSteps[side][1] };
  for (const Block& candidate : { block, other })
  {
    if (this->Ramp(error) > 0.0f && this->Exists(candidate))
    {
      error = std::min(error, SaturationShare * this->LimitSquare(candidate));
    }
  }
  if (isFine && this->Ramp(error) > 0.0f)
  {
    error = std::min(error, this->ProjectEdge(block, side));
  }
  this->EdgeErrors.emplace(key, error);
  return error;
}

// The morph of the faces of a split square; 0 if the square is not split.
float TerrainBisection::GetSquareMorph(const Block& block)
{
  return this->Ramp(this->LimitSquare(block));
}

// The same for the faces of the split triangles at a side.
float TerrainBisection::GetEdgeMorph(const Block& block, int side)
{
  return this->Ramp(this->LimitEdge(block, side));
}

bool TerrainBisection::IsVisible(const Block& block) const
{
  const auto column = static_cast<double>(block.Column);
  const auto row = static_cast<double>(block.Row);
  TerrainBox box =
    this->GetRegion(block.Level, { { column, column + 1.0 } }, { { row, row + 1.0 } });
  const double error = this->View->GetShapeError(block.Level, true, box) +
    this->Errors.GetSquareError(
      block.Level, static_cast<int>(block.Column), static_cast<int>(block.Row));
  box.Heights[0] -= error;
  box.Heights[1] += error;
  if (this->Base && box.Heights[0] <= box.Heights[1])
  {
    box.Heights[0] = std::min(box.Heights[0], *this->Base);
  }
  return this->View->IsVisible(box);
}

// Whether a part of the block belongs to the share.
bool TerrainBisection::IsShared(const Block& block) const
{
  const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), block.Level);
  const auto column = static_cast<double>(block.Column);
  const auto row = static_cast<double>(block.Row);
  return !this->Share ||
    this->Share->Overlaps(
      { { column * size, (column + 1.0) * size } }, { { row * size, (row + 1.0) * size } });
}

void TerrainBisection::Select(const TerrainView& view, double tolerance, HeightTileSource& tiles)
{
  this->View = &view;
  this->Tolerance = tolerance;
  this->Tiles = &tiles;
  this->SquareErrors.clear();
  this->EdgeErrors.clear();
  this->Corners.clear();
  this->Faces.clear();
  this->HiddenBlocks.clear();
  this->Error = 0.0;
  this->Complete = true;
  const Block root = { this->RootLevel, 0, 0 };
  float visibility = 1.0f;
  if (this->Exists(root) && this->FindTile(root.Level, root, InfiniteError, visibility) &&
    this->FindTile(root.Level - 1, root, InfiniteError, visibility))
  {
    this->Visit(root);
  }
}

bool TerrainBisection::HasTooManyFaces() const
{
  return this->Faces.size() + this->HiddenBlocks.size() > MaximumFaces;
}

// Adds the faces of a split square.
void TerrainBisection::Visit(const Block& block)
{
  if (!this->Exists(block) || this->HasTooManyFaces())
  {
    return;
  }
  if (!this->IsShared(block) || !this->IsVisible(block))
  {
    this->HiddenBlocks.push_back(
      { block.Level, block.Column, block.Row, &this->GetTile(block.Level, block) });
    return;
  }
  bool isQuarterSplit[4] = { false, false, false, false };
  for (int side = 0; side < 4; ++side)
  {
    const float morph = this->GetEdgeMorph(block, side);
    if (morph <= 0.0f)
    {
      const float square = this->GetSquareMorph(block);
      this->AddFace(block, side, -1, square,
        square < 1.0f ? GetRemainder(square) * this->ProjectSquare(block)
                      : this->ProjectEdge(block, side));
      continue;
    }
    for (int end = side; end < side + 2; ++end)
    {
      const int corner = end % 4;
      const Block quarter = { block.Level - 1, 2 * block.Column + relevo::Corners[corner][0] / 2,
        2 * block.Row + relevo::Corners[corner][1] / 2 };
      if (this->GetSquareMorph(quarter) > 0.0f)
      {
        isQuarterSplit[corner] = true;
      }
      else
      {
        this->AddFace(block, side, corner, morph,
          morph < 1.0f ? GetRemainder(morph) * this->ProjectEdge(block, side)
                       : this->ProjectSquare(quarter));
      }
    }
  }
  // Near quarters come first, so that they hide far ones before these are shaded.
  const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), block.Level);
  const auto& eye = this->View->GetRasterEye();
  const bool isRight = eye[0] > (static_cast<double>(block.Column) + 0.5) * size;
  const bool isLower = eye[1] > (static_cast<double>(block.Row) + 0.5) * size;
  const int nearest = isLower ? (isRight ? 2 : 3) : (isRight ? 1 : 0);
  for (int i : { 0, 1, 3, 2 })
  {
    const int corner = (nearest + i) % 4;
    if (isQuarterSplit[corner])
    {
      this->Visit({ block.Level - 1, 2 * block.Column + relevo::Corners[corner][0] / 2,
        2 * block.Row + relevo::Corners[corner][1] / 2 });
    }
  }
}

// Adds a triangle between the centre of a block and a side or, with an end, half a side.
void TerrainBisection::AddFace(const Block& block, int side, int end, float morph, double error)
{
  TerrainFace face;
  face.Level = block.Level - 1;
  face.Morph = morph;
  face.Error = static_cast<float>(error);
  // Points of the block, in halves of its size; Segments cells of the lattice are one half.
  std::array<int, 2> apex;
  std::array<int, 2> first;
  std::array<int, 2> second;
  const auto* a = relevo::Corners[side];
  const auto* b = relevo::Corners[(side + 1) % 4];
  if (end < 0)
  {
    face.Made = TerrainFace::Origin::Square;
    // The square was split into two triangles along one of its diagonals.
    const bool isMain = (block.Column + block.Row) % 2 == 0;
    const bool isFirst = (a[0] == a[1]) == isMain;
    apex = { { 1, 1 } };
    first = { { isFirst ? a[0] : b[0], isFirst ? a[1] : b[1] } };
    second = { { isFirst ? b[0] : a[0], isFirst ? b[1] : a[1] } };
  }
  else
  {
    face.Made = TerrainFace::Origin::Edge;
    apex = { { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2 } };
    first = { { relevo::Corners[end][0], relevo::Corners[end][1] } };
    second = { { 1, 1 } };
  }
  const std::int64_t origin[2] = { 2 * Segments * block.Column, 2 * Segments * block.Row };
  const int size[2] = { this->Columns, this->Rows };
  std::array<std::array<std::int64_t, 2>, 3> corners;
  for (int axis = 0; axis < 2; ++axis)
  {
    face.Apex[axis] = origin[axis] + Segments * apex[axis];
    face.Step1[axis] = first[axis] - apex[axis];
    face.Step2[axis] = second[axis] - apex[axis];
    corners[0][axis] = face.Apex[axis];
    corners[1][axis] = face.Apex[axis] + Segments * face.Step1[axis];
    corners[2][axis] = face.Apex[axis] + Segments * face.Step2[axis];
    const std::int64_t least = std::min({ corners[0][axis], corners[1][axis], corners[2][axis] });
    if (std::ldexp(static_cast<double>(least), face.Level) >= size[axis] - 1)
    {
      return; // the face is beyond the last sample
    }
  }
  // A point inside the face belongs to one share.
  const std::array<double, 2> inside = face.GetSample(2, 2);
  if (this->Share && !this->Share->Contains(inside[0], inside[1]))
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    const int shift = face.Level - FinestLevel;
    face.CornerHeights[i] = this->GetCornerHeight(corners[i][0] << shift, corners[i][1] << shift);
  }
  face.Tile = &this->GetTile(face.Level, block);
  face.CoarseTile = &this->GetTile(face.Level + 1, block);
  if (error > this->Tolerance)
  {
    face.Error = static_cast<float>(this->ProjectFace(block, side, end, face));
  }
  this->Error = std::max<double>(this->Error, face.Error);
  this->Faces.push_back(face);
}

// The projected error of a face at its own distance, which can be much larger than that of the
// region from which errors decide.
double TerrainBisection::ProjectFace(
  const Block& block, int side, int end, const TerrainFace& face) const
{
  // The error of the parent bounds that of a face that is not fully visible.
  const bool isSplit = face.Morph >= 1.0f;
  float heightError = 0.0f;
  if (end < 0)
  {
    heightError = isSplit ? this->GetEdgeError(block, side)
                          : this->Errors.GetSquareError(block.Level, static_cast<int>(block.Column),
                              static_cast<int>(block.Row));
  }
  else
  {
    const int column = static_cast<int>(2 * block.Column) + relevo::Corners[end][0] / 2;
    const int row = static_cast<int>(2 * block.Row) + relevo::Corners[end][1] / 2;
    heightError = isSplit ? this->Errors.GetSquareError(block.Level - 1, column, row)
                          : this->GetEdgeError(block, side);
  }
  // The level of the bisection that the error is of.
  const bool isSquare = (end < 0) != isSplit;
  const int level = end >= 0 && isSplit ? block.Level - 1 : block.Level;
  const double remainder = isSplit ? 1.0 : GetRemainder(face.Morph);
  const FaceHeights heights(face);
  const auto extend = [](std::array<double, 2>& range, double value) {
    range = { { std::min(range[0], value), std::max(range[1], value) } };
  };
  double largest = 0.0;
  for (const TerrainFace::PatternTriangle& triangle : TerrainFace::GetPattern())
  {
    TerrainBox box = { { { InfiniteError, -InfiniteError } }, { { InfiniteError, -InfiniteError } },
      { { InfiniteError, -InfiniteError } } };
    for (const auto& [a, b] : triangle)
    {
      const std::array<double, 2> sample = face.GetSample(a, b);
      extend(box.Columns, sample[0]);
      extend(box.Rows, sample[1]);
      const double height = heights.GetHeight(a, b);
      if (!std::isnan(height))
      {
        extend(box.Heights, height);
      }
    }
    const double distance =
      remainder * (heightError + this->View->GetShapeError(level, isSquare, box));
    box.Heights[0] -= distance;
    box.Heights[1] += distance;
    largest = std::max(largest, this->View->Project(distance, box));
  }
  return largest;
}

// A corner of faces, in cells of the finest lattice.
float TerrainBisection::GetCornerHeight(std::int64_t x, std::int64_t y)
{
  const std::uint64_t key = MakeGridKey(x, y);
  const auto known = this->Corners.find(key);
  if (known != this->Corners.end())
  {
    return known->second;
  }
  const float height = this->ComputeCornerHeight(x, y);
  this->Corners.emplace(key, height);
  return height;
}

// The faces around a corner have different levels. Its height is that of the finest.
float TerrainBisection::ComputeCornerHeight(std::int64_t x, std::int64_t y)
{
  const auto getHeight = [this, x, y](int level, const Block& block)
  {
    return GetLatticeHeight(
      this->GetTile(level, block), level, x >> (level - FinestLevel), y >> (level - FinestLevel));
  };
  // The coarsest level whose blocks have this corner.
  int level = FinestLevel;
  while (
    level < this->RootLevel && ((x | y) & ((std::int64_t(1) << GetBlockShift(level + 1)) - 1)) == 0)
  {
    ++level;
  }
  float height = 0.0f;
  if (level == this->RootLevel)
  {
    height = getHeight(level, { level, 0, 0 });
  }
  else
  {
    // It is the centre of a square of the next coarser level, or the midpoint of a side of one.
    const std::int64_t column = x >> GetBlockShift(level);
    const std::int64_t row = y >> GetBlockShift(level);
    Block parent = { level + 1, column >> 1, row >> 1 };
    float morph = 1.0f;
    if (column % 2 != 0 && row % 2 != 0)
    {
      morph = this->GetSquareMorph(parent);
    }
    else
    {
      int side = column % 2 != 0 ? 0 : 3;
      if (!this->Exists(parent) || this->GetSquareMorph(parent) <= 0.0f)
      {
        parent.Column -= side == 3 ? 1 : 0;
        parent.Row -= side == 0 ? 1 : 0;
        side = side == 0 ? 2 : 1;
      }
      morph = this->GetEdgeMorph(parent, side);
    }
    const float fine = getHeight(level, parent);
    height = morph < 1.0f ? MixHeights(getHeight(level + 1, parent), fine, morph) : fine;
  }
  for (; level > 0; --level)
  {
    const std::int64_t column = x >> GetBlockShift(level);
    const std::int64_t row = y >> GetBlockShift(level);
    float morph = 0.0f;
    Block finest = { level, 0, 0 };
    for (int i = 0; i < 4; ++i)
    {
      const Block block = { level, column - i % 2, row - i / 2 };
      const float candidate = this->Exists(block) ? this->GetSquareMorph(block) : 0.0f;
      if (candidate > morph)
      {
        morph = candidate;
        finest = block;
      }
    }
    if (morph <= 0.0f)
    {
      break;
    }
    const float fine = getHeight(level - 1, finest);
    height = morph < 1.0f ? MixHeights(getHeight(level, finest), fine, morph) : fine;
  }
  return height;
}
}
