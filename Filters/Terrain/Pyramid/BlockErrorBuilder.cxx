// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/BlockErrorBuilder.h"

#include "Pyramid/RasterEstimates.h"
#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr int BlocksPerTile = BlockErrors::BlocksPerTile;
constexpr int StepsPerOctave = BlockErrors::StepsPerOctave;
constexpr std::int16_t None = std::numeric_limits<std::int16_t>::min();

// A saturated error is at least 2^(1/8) times the next.
constexpr int StepsToSaturate = 1;

// Larger errors would have no saturated error in a float.
constexpr double MaximumCode = 900.0;

constexpr float Missing = std::numeric_limits<float>::quiet_NaN();

// Calls a function with column, row and code of each error of a kind that is not 0.
template <typename Tiles, typename Function>
void ForEachCode(const Tiles& tiles, int kind, const Function& function)
{
  for (const auto& [key, tile] : tiles)
  {
    for (int i = 0; i < BlocksPerTile * BlocksPerTile; ++i)
    {
      if (tile[kind][i] != None)
      {
        function(GetKeyColumn(key) * BlocksPerTile + i % BlocksPerTile,
          GetKeyRow(key) * BlocksPerTile + i / BlocksPerTile, tile[kind][i]);
      }
    }
  }
}
}

BlockErrorBuilder::BlockErrorBuilder(const PyramidFile& file)
  : File(file)
  , Sampler(file)
  , RootLevel(BlockErrors::GetRootLevel(file.GetSize(0)[0], file.GetSize(0)[1]))
  , SampleDistance(GetSampleDistance(file.Describe()))
  , Levels(this->RootLevel + 1)
{
}

std::unique_ptr<BlockErrorArea> BlockErrorBuilder::NewArea(const SampleWindow& window)
{
  return std::make_unique<BlockErrorArea>(
    0, window.Column, window.Row, window.Width, window.Height);
}

// Converts samples to heights.
void BlockErrorBuilder::ScaleReference(BlockErrorArea& area) const
{
  const RasterDescription& contents = this->File.Describe();
  for (double& sample : area.GetReference().Values)
  {
    sample = contents.Scale * sample + contents.Offset;
  }
}

void BlockErrorBuilder::SetSamples(
  BlockErrorArea& area, const SampleWindow& window, const std::vector<double>& samples) const
{
  int previous = -1;
  for (int level = 0; level <= std::min(Step, this->RootLevel); ++level)
  {
    const int source = this->Sampler.GetPyramidLevel(level);
    if (source == window.Level && source == previous)
    {
      area.ThinHeights(level);
    }
    else if (source == window.Level)
    {
      const std::array<int, 2> first = area.GetFirstVertex(level);
      const std::array<int, 2> size = area.GetNumberOfVertices(level);
      ValueGrid<float> heights(size[0], size[1]);
      this->Sampler.Interpolate(
        window, samples.data(), level, first[0], first[1], size[0], size[1], heights.Values.data());
      area.GetLevel(level).Heights = std::move(heights);
    }
    previous = source;
  }
}

void BlockErrorBuilder::Add(BlockErrorArea& area)
{
  const int base = area.GetBaseLevel();
  const int last = std::min(base + Step, this->RootLevel);
  area.Measure(last, this->SampleDistance);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (int level = base == 0 ? 0 : base + 1; level <= last; ++level)
  {
    std::array<int, 2> first = area.GetFirstVertex(level);
    for (int& block : first)
    {
      block /= BlockErrors::CellsPerBlock * (level == 0 ? 2 : 1);
    }
    this->StoreSquares(level, first, area.GetLevel(level).Square);
    this->StoreFaces(level, first, area.GetLevel(level).Faces);
  }
  if (base + Step < this->RootLevel)
  {
    this->StoreBlocks(area);
  }
}

std::int16_t BlockErrorBuilder::Encode(float error)
{
  if (!(error > 0.0f))
  {
    return None;
  }
  const double steps = std::ceil(StepsPerOctave * std::log2(static_cast<double>(error)));
  return static_cast<std::int16_t>(std::min(steps, MaximumCode));
}

void BlockErrorBuilder::Raise(Tiles& tiles, int kind, int column, int row, std::int16_t code)
{
  const std::uint64_t key = MakeGridKey(column / BlocksPerTile, row / BlocksPerTile);
  auto found = tiles.find(key);
  if (found == tiles.end())
  {
    Tile empty;
    for (auto& codes : empty)
    {
      codes.fill(None);
    }
    found = tiles.emplace(key, empty).first;
  }
  std::int16_t& known =
    found->second[kind][row % BlocksPerTile * BlocksPerTile + column % BlocksPerTile];
  known = std::max(known, code);
}

void BlockErrorBuilder::StoreSquares(
  int level, const std::array<int, 2>& first, const ValueGrid<float>& errors)
{
  for (int row = 0; row < errors.Height; ++row)
  {
    for (int column = 0; column < errors.Width; ++column)
    {
      const std::int16_t code = Encode(errors.At(column, row));
      if (code != None)
      {
        Raise(this->Levels[level], BlockErrors::Square, first[0] + column, first[1] + row, code);
      }
    }
  }
}

// The error of an edge is the larger one of two blocks.
void BlockErrorBuilder::StoreFaces(
  int level, const std::array<int, 2>& first, const ValueGrid<BlockErrorArea::Sides>& errors)
{
  for (int row = 0; row < errors.Height; ++row)
  {
    for (int column = 0; column < errors.Width; ++column)
    {
      for (int side = 0; side < 4; ++side)
      {
        const std::int16_t code = Encode(errors.At(column, row)[side]);
        if (code != None)
        {
          Raise(this->Levels[level], BlockErrors::RowEdge + side % 2,
            first[0] + column + (side == 1 ? 1 : 0), first[1] + row + (side == 2 ? 1 : 0), code);
        }
      }
    }
  }
}

// Stores what the measurement of coarser levels needs.
void BlockErrorBuilder::StoreBlocks(BlockErrorArea& area)
{
  const int level = area.GetBaseLevel() + Step;
  const BlockErrorArea::Level& result = area.GetLevel(level);
  const std::array<int, 2> first = area.GetFirstVertex(level);
  constexpr int cells = BlockErrors::CellsPerBlock;
  for (int row = 0; row < result.Contents.Height; ++row)
  {
    for (int column = 0; column < result.Contents.Width; ++column)
    {
      Block block;
      for (int i = 0; i < VerticesPerBlock * VerticesPerBlock; ++i)
      {
        block.Heights[i] = result.Heights.GetNearest(
          cells * column + i % VerticesPerBlock, cells * row + i / VerticesPerBlock);
      }
      for (int i = 0; i < 4; ++i)
      {
        block.Corners[i] = result.Corners.At(column + i % 2, row + i / 2);
      }
      block.Contents = result.Contents.At(column, row);
      block.Base = result.Bases.At(column, row);
      this->Blocks[level / Step - 1].emplace(
        MakeGridKey(first[0] / cells + column, first[1] / cells + row), block);
    }
  }
}

void BlockErrorBuilder::RequestAreas(int pyramidLevel, int column, int row)
{
  // The sample contributes to heights up to the next samples.
  std::array<std::array<double, 2>, 2> samples;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = this->File.GetSize(0)[axis];
    const double ratio = size / this->File.GetSize(pyramidLevel)[axis];
    const int position = axis == 0 ? column : row;
    samples[axis][0] = std::clamp((position - 0.5) * ratio - 0.5, 0.0, size - 1.0);
    samples[axis][1] = std::clamp((position + 1.5) * ratio - 0.5, 0.0, size - 1.0);
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (int base = 0; base < this->RootLevel; base += Step)
  {
    if (pyramidLevel < this->Sampler.GetPyramidLevel(base) ||
      pyramidLevel > this->Sampler.GetPyramidLevel(base + Step))
    {
      continue;
    }
    const double size = std::ldexp(static_cast<double>(SamplesPerArea), base);
    const auto getArea = [size](double sample) { return static_cast<int>(sample / size); };
    for (int y = getArea(samples[1][0]); y <= getArea(samples[1][1]); ++y)
    {
      for (int x = getArea(samples[0][0]); x <= getArea(samples[0][1]); ++x)
      {
        this->Requests[base / Step].insert(MakeGridKey(x, y));
      }
    }
  }
}

std::vector<SampleWindow> BlockErrorBuilder::GetRequestedAreas() const
{
  const std::array<int, 2>& size = this->File.GetSize(0);
  std::vector<SampleWindow> windows;
  for (const std::uint64_t key : this->Requests[0])
  {
    SampleWindow window;
    window.Column = GetKeyColumn(key) * SamplesPerArea;
    window.Row = GetKeyRow(key) * SamplesPerArea;
    window.Width = std::min(SamplesPerArea + 1, size[0] - window.Column);
    window.Height = std::min(SamplesPerArea + 1, size[1] - window.Row);
    windows.push_back(window);
  }
  return windows;
}

std::shared_ptr<const BlockErrors> BlockErrorBuilder::Finish(
  const std::atomic<bool>& abort, std::string& error)
{
  for (int base = Step; base < this->RootLevel && !abort; base += Step)
  {
    this->MeasureCoarser(base, abort, error);
  }
  return this->MakeErrors(this->Saturate());
}

void BlockErrorBuilder::MeasureCoarser(
  int baseLevel, const std::atomic<bool>& abort, std::string& error)
{
  constexpr int blocksPerArea = SamplesPerArea / BlockErrors::CellsPerBlock;
  Keys areas = this->Requests[baseLevel / Step];
  for (const auto& block : this->Blocks[baseLevel / Step - 1])
  {
    areas.insert(MakeGridKey(
      GetKeyColumn(block.first) / blocksPerArea, GetKeyRow(block.first) / blocksPerArea));
  }
  for (const std::uint64_t key : areas)
  {
    const std::unique_ptr<BlockErrorArea> area =
      this->NewCoarserArea(baseLevel, GetKeyColumn(key), GetKeyRow(key));
    if (abort || !area)
    {
      continue;
    }
    for (int level = baseLevel + 1; level <= std::min(baseLevel + Step, this->RootLevel); ++level)
    {
      if (this->Sampler.GetPyramidLevel(level) == this->Sampler.GetPyramidLevel(level - 1))
      {
        area->ThinHeights(level);
        continue;
      }
      const std::array<int, 2> first = area->GetFirstVertex(level);
      const std::array<int, 2> size = area->GetNumberOfVertices(level);
      ValueGrid<float> heights(size[0], size[1]);
      std::string failure;
      if (!this->Sampler.Read(
            level, first[0], first[1], size[0], size[1], heights.Values.data(), failure))
      {
        std::fill(heights.Values.begin(), heights.Values.end(), Missing);
        error = error.empty() ? failure : error;
      }
      area->GetLevel(level).Heights = std::move(heights);
    }
    this->Add(*area);
  }
}

// An area whose reference is the lattice of the base level; nullptr beyond the last vertex.
std::unique_ptr<BlockErrorArea> BlockErrorBuilder::NewCoarserArea(
  int baseLevel, int column, int row) const
{
  const int first[2] = { column * SamplesPerArea, row * SamplesPerArea };
  int size[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const int last = (this->File.GetSize(0)[axis] - 2 + (1 << baseLevel)) >> baseLevel;
    size[axis] = std::min(SamplesPerArea, last - first[axis]) + 1;
    if (size[axis] < 2)
    {
      return nullptr;
    }
  }
  auto area = std::make_unique<BlockErrorArea>(baseLevel, first[0], first[1], size[0], size[1]);
  const RasterDescription& contents = this->File.Describe();
  const auto absent =
    static_cast<float>(contents.Scale * this->File.GetAbsentSample() + contents.Offset);
  const std::array<int, 2> blocks = area->GetNumberOfBlocks(baseLevel);
  BlockErrorArea::Level& base = area->GetLevel(baseLevel);
  base.Heights = ValueGrid<float>(size[0], size[1], absent);
  base.Corners =
    ValueGrid<BlockErrorArea::Range>(blocks[0] + 1, blocks[1] + 1, { { absent, absent } });
  base.Contents = ValueGrid<std::uint8_t>(blocks[0], blocks[1],
    std::isnan(absent) ? BlockErrorArea::HasMissing : BlockErrorArea::HasData);
  base.Bases = ValueGrid<float>(blocks[0], blocks[1], 0.0f);
  constexpr int cells = BlockErrors::CellsPerBlock;
  const auto& known = this->Blocks[baseLevel / Step - 1];
  for (int j = 0; j < blocks[1]; ++j)
  {
    for (int i = 0; i < blocks[0]; ++i)
    {
      const auto found = known.find(MakeGridKey(first[0] / cells + i, first[1] / cells + j));
      if (found == known.end())
      {
        continue;
      }
      const Block& block = found->second;
      base.Contents.At(i, j) = block.Contents;
      base.Bases.At(i, j) = block.Base;
      for (int k = 0; k < 4; ++k)
      {
        base.Corners.At(i + k % 2, j + k / 2) = block.Corners[k];
      }
      for (int k = 0; k < VerticesPerBlock * VerticesPerBlock; ++k)
      {
        const int x = cells * i + k % VerticesPerBlock;
        const int y = cells * j + k / VerticesPerBlock;
        if (x < size[0] && y < size[1])
        {
          base.Heights.At(x, y) = block.Heights[k];
        }
      }
    }
  }
  area->GetReference().Values.assign(base.Heights.Values.begin(), base.Heights.Values.end());
  return area;
}

/*
 * Raises errors until they are saturated, from fine to coarse levels. Returns the code of the
 * largest error, which is that of the root. Errors that are too small for a code are raised, too.
 */
std::int16_t BlockErrorBuilder::Saturate()
{
  int largest = None;
  for (int level = 0; level <= this->RootLevel; ++level)
  {
    const int steps = 2 * StepsToSaturate * (this->RootLevel - level);
    for (int kind = 0; kind < BlockErrors::NumberOfKinds; ++kind)
    {
      const int own = kind == BlockErrors::Square ? steps : steps + StepsToSaturate;
      ForEachCode(this->Levels[level], kind,
        [&](int, int, std::int16_t code) { largest = std::max(largest, code + own); });
    }
  }
  const int smallest = largest - BlockErrors::LargestCode + 1;
  for (int level = 0; level <= this->RootLevel; ++level)
  {
    for (auto& tile : this->Levels[level])
    {
      for (auto& codes : tile.second)
      {
        for (std::int16_t& code : codes)
        {
          code = code == None ? None : std::max(code, static_cast<std::int16_t>(smallest));
        }
      }
    }
    if (level > 0)
    {
      this->SaturateEdges(level, smallest);
      this->SaturateSquares(level);
    }
  }
  return static_cast<std::int16_t>(largest);
}

// Raises the errors of edges to those of the finer squares at them.
void BlockErrorBuilder::SaturateEdges(int level, int smallest)
{
  Tiles& tiles = this->Levels[level];
  const std::array<int, 2> size = this->GetNumberOfBlocks(level);
  const auto raise = [&](int axis, int column, int row, int code)
  {
    Raise(tiles, BlockErrors::RowEdge + axis, column, row,
      static_cast<std::int16_t>(code + StepsToSaturate));
  };
  if (level > 1)
  {
    ForEachCode(this->Levels[level - 1], BlockErrors::Square,
      [&](int column, int row, std::int16_t code)
      {
        raise(0, column / 2, (row + 1) / 2, code);
        raise(1, (column + 1) / 2, row / 2, code);
      });
    return;
  }
  // The square errors of level 0 depend on the stored errors around; see BlockErrors.
  ForEachCode(this->Levels[0], BlockErrors::Square,
    [&](int column, int row, std::int16_t code)
    {
      const int around = std::max(smallest, code + BlockErrors::StepsToNeighborOfLevel0);
      for (int i = 0; i < 9; ++i)
      {
        const int x = column + i % 3 - 1;
        const int y = row + i / 3 - 1;
        for (int side = 0; side < 4 && x >= 0 && y >= 0 && x < size[0] && y < size[1]; ++side)
        {
          raise(side % 2, x + (side == 1 ? 1 : 0), y + (side == 2 ? 1 : 0), i == 4 ? code : around);
        }
      }
    });
}

// Raises the errors of squares to those of their edges.
void BlockErrorBuilder::SaturateSquares(int level)
{
  Tiles& tiles = this->Levels[level];
  const std::array<int, 2> size = this->GetNumberOfBlocks(level);
  const Tiles edges = tiles; // raising adds tiles
  for (int axis = 0; axis < 2; ++axis)
  {
    ForEachCode(edges, BlockErrors::RowEdge + axis,
      [&](int column, int row, std::int16_t code)
      {
        for (int before = 0; before < 2; ++before)
        {
          const int x = column - (axis == 1 ? before : 0);
          const int y = row - (axis == 0 ? before : 0);
          if (x >= 0 && y >= 0 && x < size[0] && y < size[1])
          {
            Raise(
              tiles, BlockErrors::Square, x, y, static_cast<std::int16_t>(code + StepsToSaturate));
          }
        }
      });
  }
}

std::shared_ptr<const BlockErrors> BlockErrorBuilder::MakeErrors(std::int16_t largest) const
{
  auto errors = std::make_shared<BlockErrors>(this->RootLevel);
  errors->SetLargest(
    largest == None ? 0.0f : std::exp2(static_cast<float>(largest) / StepsPerOctave));
  const auto getCode = [largest](std::int16_t code) {
    return static_cast<std::uint8_t>(code == None ? 0 : code - largest + BlockErrors::LargestCode);
  };
  for (int level = 0; level <= this->RootLevel; ++level)
  {
    for (const auto& [key, tile] : this->Levels[level])
    {
      BlockErrors::Tile& stored = errors->GetTiles(level)[key];
      for (int kind = 0; kind < BlockErrors::NumberOfKinds; ++kind)
      {
        std::transform(tile[kind].begin(), tile[kind].end(), stored[kind].begin(), getCode);
      }
    }
  }
  return errors;
}

std::array<int, 2> BlockErrorBuilder::GetNumberOfBlocks(int level) const
{
  std::array<int, 2> blocks;
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::int64_t size = std::int64_t(BlockErrors::CellsPerBlock) << level;
    blocks[axis] = static_cast<int>((this->File.GetSize(0)[axis] - 2 + size) / size);
  }
  return blocks;
}
}
