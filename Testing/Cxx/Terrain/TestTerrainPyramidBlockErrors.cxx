// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The index of a raster has bounds of the errors of the blocks of a bisection, and the ranges of
// heights. The test compares heights of faces as they are drawn with the surface of full resolution
// at many points.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "Bisection/FaceHeights.h"
#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "Pyramid/LatticeSampler.h"
#include "Pyramid/PyramidIndexBuilder.h"
#include "Pyramid/RasterEstimates.h"
#include "Pyramid/RasterPyramid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <tuple>

namespace
{
namespace fs = std::filesystem;
using relevo::BlockErrors;
using relevo::TerrainFace;

constexpr int Segments = TerrainFace::Segments;
constexpr double NoHeight = std::numeric_limits<double>::quiet_NaN();
const double SaturationRatio = std::exp2(0.125);

// The corners of a face have the heights of their own level, or the lowest or highest of finer
// levels.
enum class Corners
{
  Own,
  Lowest,
  Highest
};

// The faces of a raster as the mapper draws them.
class DrawnTerrain
{
public:
  explicit DrawnTerrain(const relevo::RasterPyramid& pyramid)
    : Sampler(pyramid.GetFile())
  {
  }

  // The height of a face of a square, or of a split square, at a point of a block.
  double GetHeight(
    int level, int column, int row, bool isSplit, Corners corners, double x, double y)
  {
    const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), level);
    const double u = x / size - column;
    const double v = y / size - row;
    TerrainFace face;
    face.Made = isSplit ? TerrainFace::Origin::Square : TerrainFace::Origin::Edge;
    face.Level = isSplit ? level - 1 : level;
    if (isSplit)
    {
      const double right = u - 0.5;
      const double down = v - 0.5;
      face.Apex = { { 2 * Segments * column + Segments, 2 * Segments * row + Segments } };
      const bool isSide = std::abs(right) >= std::abs(down);
      const int sign = (isSide ? right : down) >= 0.0 ? 1 : -1;
      face.Step1 = { { isSide ? sign : -sign, isSide ? -sign : sign } };
      face.Step2 = { { sign, sign } };
    }
    else
    {
      const bool isMain = (column + row) % 2 == 0;
      const bool isUpper = isMain ? v <= u : u + v <= 1.0;
      const int apex[2] = { isMain == isUpper ? 1 : 0, isUpper ? 0 : 1 };
      face.Apex = { { Segments * (column + apex[0]), Segments * (row + apex[1]) } };
      face.Step1 = { { apex[0] ? -1 : 1, 0 } };
      face.Step2 = { { 0, apex[1] ? -1 : 1 } };
    }
    face.Tile = this->FindTile(std::max(face.Level, 0), level, column, row);
    face.CoarseTile = isSplit ? this->FindTile(std::max(level, 0), level, column, row) : face.Tile;
    for (int i = 0; i < 3; ++i)
    {
      const std::array<int, 2> step = i == 0 ? std::array<int, 2>{ { 0, 0 } }
        : i == 1                             ? face.Step1
                                             : face.Step2;
      face.CornerHeights[i] = this->GetCorner(face.Level, i == 0 ? face.Level : level,
        face.Apex[0] + Segments * step[0], face.Apex[1] + Segments * step[1], corners);
    }
    return Interpolate(face, std::ldexp(x, -face.Level), std::ldexp(y, -face.Level));
  }

private:
  // The triangles of the pattern in the unit square of a point.
  static const std::vector<const TerrainFace::PatternTriangle*>& FindTriangles(double a, double b)
  {
    static const auto squares = []
    {
      std::vector<std::vector<const TerrainFace::PatternTriangle*>> result(Segments * Segments);
      for (const TerrainFace::PatternTriangle& triangle : TerrainFace::GetPattern())
      {
        const int i = std::min({ triangle[0][0], triangle[1][0], triangle[2][0] });
        const int j = std::min({ triangle[0][1], triangle[1][1], triangle[2][1] });
        result[j * Segments + i].push_back(&triangle);
      }
      return result;
    }();
    const int i = std::clamp(static_cast<int>(std::floor(a)), 0, Segments - 1);
    const int j = std::clamp(static_cast<int>(std::floor(b)), 0, Segments - 1 - i);
    return squares[j * Segments + i];
  }

  // At a point in vertices of the face's level.
  static double Interpolate(const TerrainFace& face, double x, double y)
  {
    const double to[2] = { x - static_cast<double>(face.Apex[0]),
      y - static_cast<double>(face.Apex[1]) };
    const auto project = [&to](const std::array<int, 2>& step)
    { return (to[0] * step[0] + to[1] * step[1]) / (step[0] * step[0] + step[1] * step[1]); };
    const double a = project(face.Step1);
    const double b = project(face.Step2);
    const relevo::FaceHeights heights(face);
    double inside = -std::numeric_limits<double>::infinity();
    double height = 0.0;
    for (const TerrainFace::PatternTriangle* triangle : FindTriangles(a, b))
    {
      double weights[3];
      for (int i = 0; i < 3; ++i)
      {
        const std::array<int, 2>& p = (*triangle)[(i + 1) % 3];
        const std::array<int, 2>& q = (*triangle)[(i + 2) % 3];
        weights[i] = (q[0] - p[0]) * (b - p[1]) - (q[1] - p[1]) * (a - p[0]);
      }
      const double least = *std::min_element(weights, weights + 3);
      if (least > inside)
      {
        inside = least;
        height = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          height += std::abs(weights[i]) > 1e-12
            ? weights[i] * heights.GetHeight((*triangle)[i][0], (*triangle)[i][1])
            : 0.0;
        }
      }
    }
    return height;
  }

  // A corner that is a vertex of a level, in vertices of the level of a face.
  float GetCorner(int faceLevel, int level, std::int64_t x, std::int64_t y, Corners corners)
  {
    if (level <= 0)
    {
      const int shift = -faceLevel;
      const relevo::HeightTile* tile = this->FindTileOfVertex(0, x >> shift, y >> shift);
      return relevo::GetLatticeHeight(*tile, faceLevel, x, y);
    }
    float height = std::numeric_limits<float>::quiet_NaN();
    for (int finer = level; finer >= 0; --finer)
    {
      const auto convert = [=](std::int64_t position) {
        return finer > faceLevel ? position >> (finer - faceLevel)
                                 : position << (faceLevel - finer);
      };
      const relevo::HeightTile* tile = this->FindTileOfVertex(finer, convert(x), convert(y));
      const float other = relevo::GetLatticeHeight(*tile, finer, convert(x), convert(y));
      if (finer == level && corners == Corners::Own)
      {
        return other;
      }
      height = std::isnan(height)    ? other
        : corners == Corners::Lowest ? std::fmin(height, other)
                                     : std::fmax(height, other);
    }
    return height;
  }

  const relevo::HeightTile* FindTile(int tileLevel, int level, int column, int row)
  {
    const auto convert = [=](int block)
    {
      const std::int64_t first = static_cast<std::int64_t>(block) * BlockErrors::CellsPerBlock;
      return level >= tileLevel ? first << (level - tileLevel) : first >> (tileLevel - level);
    };
    return this->FindTileOfVertex(tileLevel, convert(column), convert(row));
  }

  const relevo::HeightTile* FindTileOfVertex(int level, std::int64_t x, std::int64_t y)
  {
    constexpr int size = relevo::HeightTile::CellsPerTile;
    relevo::HeightTile& tile = this->Tiles[{ level, x / size, y / size }];
    if (tile.Heights.empty())
    {
      tile.Level = level;
      tile.Column = static_cast<int>(x / size);
      tile.Row = static_cast<int>(y / size);
      std::string error;
      if (!this->Sampler.Read(tile, error))
      {
        tile.Heights.assign(
          relevo::HeightTile::Stride * relevo::HeightTile::Stride, static_cast<float>(NoHeight));
      }
    }
    return &tile;
  }

  relevo::LatticeSampler Sampler;
  std::map<std::tuple<int, std::int64_t, std::int64_t>, relevo::HeightTile> Tiles;
};

// Points of a raster, and the heights of the surface of full resolution.
struct TestPoint
{
  double X;
  double Y;
  double Height;
};

struct TestCase
{
  const char* Name;
  int Width;
  int Height;
  GDALDataType Type;
  const char* Resampling; // of overviews; nullptr for none
  bool HasHoles = false;
  bool IsSparse = false;
  bool HasScale = false;
  int PointsPerSample = 1; // or, if negative, a point for so many samples
};

std::string WriteRaster(RelevoCheck& check, const RelevoTestFolders& folders, const TestCase& one)
{
  RelevoRaster raster;
  raster.Width = one.Width;
  raster.Height = one.Height;
  raster.Type = one.Type;
  raster.Options = { "TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64" };
  raster.Transform = { 500000.0, 30.0, 0.0, 4000000.0, 0.0, -30.0 };
  raster.CoordinateSystem = "EPSG:32632";
  std::mt19937 random(11);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  raster.SetValues(
    [&](int, int column, int row)
    {
      const bool isRough = column % 97 < 30 && row % 61 < 40;
      const double cliff = column + row > one.Width ? 150.0 : 0.0;
      const double height = 900.0 * std::sin(0.013 * column) * std::cos(0.011 * row) + cliff +
        (isRough ? 25.0 : 2.0) * noise(random);
      const bool isOutside =
        one.IsSparse && (std::abs(column - 980) > 60 || std::abs(row - 700) > 90);
      const bool isHole =
        one.HasHoles && (std::hypot(column - 100, row - 90) < 40.0 || column % 89 == 7);
      return isOutside          ? 0.0
        : isHole                ? -32768.0
        : one.Type == GDT_Int16 ? std::floor(height)
                                : height;
    });
  if (one.HasHoles)
  {
    raster.NoData = -32768.0;
  }
  if (one.IsSparse)
  {
    raster.Options.emplace_back("SPARSE_OK=TRUE");
  }
  if (one.HasScale)
  {
    raster.Scale = -0.1;
    raster.Offset = 250.3;
  }
  std::string name = folders.File("TerrainPyramidBlockErrors.tif");
  fs::remove(name + ".relevo-index");
  CHECK(raster.Write(name));
  if (one.Resampling)
  {
    GDALDatasetH dataset = GDALOpen(name.c_str(), GA_Update);
    int factors[] = { 2, 4, 8, 16 };
    CHECK(GDALBuildOverviews(dataset, one.Resampling, 4, factors, 0, nullptr, nullptr, nullptr) ==
      CE_None);
    GDALClose(dataset);
  }
  return name;
}

std::shared_ptr<relevo::RasterPyramid> OpenPyramid(RelevoCheck& check, const std::string& name)
{
  std::string error;
  std::shared_ptr<relevo::RasterPyramid> pyramid = relevo::RasterPyramid::Open(name, "", error);
  CHECK(pyramid != nullptr);
  CHECK_EQUAL(error, std::string());
  return pyramid;
}

std::array<int, 2> GetNumberOfBlocks(const relevo::RasterPyramid& pyramid, int level)
{
  const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), level);
  const std::array<int, 2>& samples = pyramid.GetFile().GetSize(0);
  return { { static_cast<int>(std::ceil((samples[0] - 1) / size)),
    static_cast<int>(std::ceil((samples[1] - 1) / size)) } };
}

std::vector<TestPoint> MakePoints(relevo::RasterPyramid& pyramid, const TestCase& one)
{
  std::vector<TestPoint> points;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto add = [&](double x, double y)
  {
    TestPoint point{ std::min(x, one.Width - 1.0), std::min(y, one.Height - 1.0), 0.0 };
    std::string error;
    double sample = NoHeight;
    pyramid.Interpolate(point.X, point.Y, sample, error);
    const relevo::RasterDescription& contents = pyramid.GetFile().Describe();
    point.Height = contents.Scale * sample + contents.Offset;
    points.push_back(point);
  };
  for (int row = 0; row < one.Height; ++row)
  {
    for (int column = 0; column < one.Width; ++column)
    {
      const bool isNearData =
        one.IsSparse && std::abs(column - 1030) < 20 && row > 600 && row < 800;
      if (one.PointsPerSample < 0 && !isNearData && unit(random) * -one.PointsPerSample > 1.0)
      {
        continue;
      }
      add(column, row);
      add(column + 0.5, row); // on edges of triangles
      add(column, row + 0.5);
      add(column + 0.5, row + 0.5);
      for (int i = 0; i < one.PointsPerSample; ++i)
      {
        add(column + unit(random), row + unit(random));
      }
    }
  }
  return points;
}

// Errors of squares and edges.
class BlockValues
{
public:
  explicit BlockValues(const std::array<int, 2>& blocks)
    : Stride(blocks[0] + 1)
  {
    this->Values.fill(
      std::vector<double>(static_cast<std::size_t>(blocks[0] + 1) * (blocks[1] + 1), 0.0));
  }

  double& At(int kind, int column, int row)
  {
    return this->Values[kind][static_cast<std::size_t>(row) * this->Stride + column];
  }

private:
  int Stride;
  std::array<std::vector<double>, BlockErrors::NumberOfKinds> Values;
};

// An edge of a block.
struct Edge
{
  int Axis;
  int Column;
  int Row;
};

std::array<Edge, 4> GetEdges(int column, int row)
{
  return { { { 0, column, row }, { 0, column, row + 1 }, { 1, column, row },
    { 1, column + 1, row } } };
}

// The largest distances of faces from full resolution at points.
BlockValues Measure(DrawnTerrain& terrain, const std::vector<TestPoint>& points, int level,
  const std::array<int, 2>& blocks)
{
  BlockValues largest(blocks);
  const double size = std::ldexp(static_cast<double>(BlockErrors::CellsPerBlock), level);
  for (const TestPoint& point : points)
  {
    const int column = std::min(static_cast<int>(point.X / size), blocks[0] - 1);
    const int row = std::min(static_cast<int>(point.Y / size), blocks[1] - 1);
    const double right = point.X / size - column - 0.5;
    const double down = point.Y / size - row - 0.5;
    const int edge = std::abs(right) >= std::abs(down) ? (right >= 0.0 ? 3 : 2)
      : down >= 0.0                                    ? 1
                                                       : 0;
    const Edge nearest = GetEdges(column, row)[edge];
    double* const known[2] = { &largest.At(BlockErrors::Square, column, row),
      &largest.At(BlockErrors::RowEdge + nearest.Axis, nearest.Column, nearest.Row) };
    for (const bool isSplit : { false, true })
    {
      for (const Corners corners : { Corners::Own, Corners::Lowest, Corners::Highest })
      {
        const double height =
          terrain.GetHeight(level, column, row, isSplit, corners, point.X, point.Y);
        const double error = std::abs(height - point.Height);
        *known[isSplit] = error > *known[isSplit] ? error : *known[isSplit]; // false for NaN
        if (level <= 0)
        {
          break; // heights of finer levels are the same
        }
      }
    }
  }
  return largest;
}

// No error is less than the measured one; and the sums of errors are not much larger than those of
// measured errors that are saturated.
void CheckBounds(RelevoCheck& check, relevo::RasterPyramid& pyramid, const TestCase& one)
{
  const std::shared_ptr<const BlockErrors> errors = pyramid.GetBlockErrors();
  DrawnTerrain terrain(pyramid);
  const std::vector<TestPoint> points = MakePoints(pyramid, one);
  std::array<int, 2> finerBlocks{ { 0, 0 } };
  BlockValues finer(finerBlocks); // saturated
  for (int level = -2; level <= errors->GetRootLevel(); ++level)
  {
    CHECK_CASE(level);
    const std::array<int, 2> blocks = GetNumberOfBlocks(pyramid, level);
    BlockValues measured = Measure(terrain, points, level, blocks);
    int failures = 0;
    for (int kind = 0; kind < BlockErrors::NumberOfKinds; ++kind)
    {
      for (int row = 0; row <= blocks[1]; ++row)
      {
        for (int column = 0; column <= blocks[0]; ++column)
        {
          const double bound = kind == BlockErrors::Square
            ? errors->GetSquareError(level, column, row)
            : errors->GetEdgeError(level, column, row, kind - BlockErrors::RowEdge);
          const double error = measured.At(kind, column, row);
          if (error > bound * (1.0 + 1e-6) + 2e-3 && ++failures < 4) // heights are floats
          {
            CHECK_CASE(kind);
            CHECK_CASE(column);
            CHECK_CASE(row);
            CHECK_LESS_EQUAL(error, bound);
          }
        }
      }
    }
    CHECK_EQUAL(failures, 0);

    for (int row = 0; row < finerBlocks[1]; ++row)
    {
      for (int column = 0; column < finerBlocks[0]; ++column)
      {
        const double least = SaturationRatio * finer.At(BlockErrors::Square, column, row);
        double& rowEdge = measured.At(BlockErrors::RowEdge, column / 2, (row + 1) / 2);
        double& columnEdge = measured.At(BlockErrors::ColumnEdge, (column + 1) / 2, row / 2);
        rowEdge = std::max(rowEdge, least);
        columnEdge = std::max(columnEdge, least);
      }
    }
    double sums[2] = { 0.0, 0.0 };
    for (int row = 0; row < blocks[1]; ++row)
    {
      for (int column = 0; column < blocks[0]; ++column)
      {
        double& square = measured.At(BlockErrors::Square, column, row);
        for (const Edge& edge : GetEdges(column, row))
        {
          square = std::max(square,
            SaturationRatio * measured.At(BlockErrors::RowEdge + edge.Axis, edge.Column, edge.Row));
        }
        sums[0] += square;
        sums[1] += errors->GetSquareError(level, column, row);
        for (int axis = 0; axis < 2; ++axis)
        {
          sums[0] += measured.At(BlockErrors::RowEdge + axis, column, row);
          sums[1] += errors->GetEdgeError(level, column, row, axis);
        }
      }
    }
    finer = measured;
    finerBlocks = blocks;
    // Few points do not find the largest errors of small blocks.
    const bool hasAllPoints = one.PointsPerSample > 0;
    if (level >= (hasAllPoints ? 1 : 5) && !one.HasHoles)
    {
      CHECK_LESS_EQUAL(sums[1], (hasAllPoints ? 1.5 : 2.0) * sums[0]);
    }
  }
}

// Coarser faces are bisected before finer ones.
void CheckSaturation(RelevoCheck& check, relevo::RasterPyramid& pyramid)
{
  const std::shared_ptr<const BlockErrors> errors = pyramid.GetBlockErrors();
  const double ratio = SaturationRatio * (1.0 - 1e-6);
  // Errors of the smallest codes do not matter.
  const double smallest = std::ldexp(errors->GetLargest(), -28);
  int failures = 0;
  for (int level = -3; level <= errors->GetRootLevel(); ++level)
  {
    const std::array<int, 2> blocks = GetNumberOfBlocks(pyramid, level);
    for (int row = 0; row < blocks[1]; ++row)
    {
      for (int column = 0; column < blocks[0]; ++column)
      {
        const double square = errors->GetSquareError(level, column, row);
        for (const Edge& edge : GetEdges(column, row))
        {
          const double error = errors->GetEdgeError(level, edge.Column, edge.Row, edge.Axis);
          failures += error > smallest && square < ratio * error;
        }
        for (int i = 0; level > -3 && i < 4; ++i)
        {
          const double finer =
            errors->GetSquareError(level - 1, 2 * column + i % 2, 2 * row + i / 2);
          failures += finer > smallest &&
            (errors->GetEdgeError(level, column, row + i / 2, 0) < ratio * finer ||
              errors->GetEdgeError(level, column + i % 2, row, 1) < ratio * finer);
        }
      }
    }
    CHECK_CASE(level);
    CHECK_EQUAL(failures, 0);
  }
}

// Blocks with some missing samples have an error that draws the outline of the hole.
void CheckOutlines(RelevoCheck& check, relevo::RasterPyramid& pyramid, const std::string& name)
{
  const RelevoRaster raster = RelevoRaster::Read(name);
  const std::shared_ptr<const BlockErrors> errors = pyramid.GetBlockErrors();
  for (int level = 0; level <= errors->GetRootLevel(); ++level)
  {
    CHECK_CASE(level);
    const std::array<int, 2> blocks = GetNumberOfBlocks(pyramid, level);
    const int size = BlockErrors::CellsPerBlock << level;
    int failures = 0;
    for (int row = 0; row < blocks[1]; ++row)
    {
      for (int column = 0; column < blocks[0]; ++column)
      {
        bool has[2] = { false, false };
        for (int y = row * size; y < std::min((row + 1) * size + 1, raster.Height); ++y)
        {
          for (int x = column * size; x < std::min((column + 1) * size + 1, raster.Width); ++x)
          {
            has[raster.At(0, x, y) == raster.NoData] = true;
          }
        }
        const double outline = 0.25 * std::ldexp(30.0, level) * (1.0 - 1e-6);
        double least = errors->GetSquareError(level, column, row);
        for (const Edge& edge : GetEdges(column, row))
        {
          const double error = errors->GetEdgeError(level, edge.Column, edge.Row, edge.Axis);
          least = level > 0 ? std::min(least, error) : least;
        }
        failures += has[0] && has[1] && least < outline;
      }
    }
    CHECK_EQUAL(failures, 0);
  }
}

// The ranges of heights contain those of the samples, and are those of tiles for whole tiles.
void CheckRanges(RelevoCheck& check, relevo::RasterPyramid& pyramid, const TestCase& one)
{
  const std::shared_ptr<const relevo::ElevationRanges> ranges = pyramid.GetElevationRanges();
  const relevo::RasterDescription& contents = pyramid.GetFile().Describe();
  constexpr int size = relevo::ElevationRanges::SamplesPerTile;
  for (int row = 0; row < one.Height; row += size)
  {
    for (int column = 0; column < one.Width; column += size)
    {
      relevo::SampleWindow window{ 0, column, row, std::min(size, one.Width - column),
        std::min(size, one.Height - row) };
      std::vector<double> samples(window.GetNumberOfSamples());
      std::string error;
      CHECK(pyramid.GetFile().Read(window, samples.data(), error));
      double lowest = std::numeric_limits<double>::infinity();
      double highest = -lowest;
      for (const double sample : samples)
      {
        const double height = contents.Scale * sample + contents.Offset;
        lowest = height < lowest ? height : lowest;
        highest = height > highest ? height : highest;
      }
      const relevo::ElevationRanges::Range range =
        ranges->Get(0, { { column + 0.5, column + 0.6 } }, { { row + 0.5, row + 0.6 } });
      CHECK_LESS_EQUAL(range[0], lowest);
      CHECK_GREATER_EQUAL(range[1], highest);
      if (!one.IsSparse && lowest <= highest)
      {
        CHECK_NEAR(range[0], lowest, 1e-3);
        CHECK_NEAR(range[1], highest, 1e-3);
      }
    }
  }
}

std::string ReadFile(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

// The index is the same for any number of threads and any limit of their memory.
std::string BuildIndex(RelevoCheck& check, const relevo::PyramidFile& file,
  const std::string& indexName, int numberOfThreads, std::int64_t memoryLimit)
{
  std::vector<std::array<int, 2>> sizes;
  for (int level = 0; level < file.GetNumberOfLevels(); ++level)
  {
    sizes.push_back(file.GetSize(level));
  }
  relevo::PyramidIndex index(sizes);
  const std::atomic<bool> abort{ false };
  std::string error;
  relevo::PyramidIndexBuilder builder(file, abort);
  builder.SetMemoryLimit(memoryLimit);
  CHECK(builder.Build(numberOfThreads, index, error));
  CHECK_EQUAL(error, std::string());
  CHECK_EQUAL(index.Write(indexName, file.GetSignature()), std::string());
  return ReadFile(indexName);
}

void TestCases(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const TestCase cases[] = {
    { "plain", 161, 93, GDT_Int16, nullptr },
    { "float", 50, 131, GDT_Float32, nullptr },
    { "average", 180, 113, GDT_Int16, "AVERAGE" },
    { "nearest", 129, 141, GDT_Float32, "NEAREST" },
    { "scale", 122, 100, GDT_Float64, "AVERAGE", false, false, true },
    { "holes", 181, 140, GDT_Int16, "AVERAGE", true },
    { "holes without overviews", 120, 160, GDT_Float32, nullptr, true },
    { "two rows", 600, 2, GDT_Int16, "AVERAGE" },
    { "sparse", 1700, 1100, GDT_Int16, "AVERAGE", false, true, false, -100 },
    { "large", 2300, 1030, GDT_Int16, "AVERAGE", false, false, false, -150 },
    { "large with holes", 1300, 1100, GDT_Float32, "AVERAGE", true, false, false, -100 },
    { "large without overviews", 1030, 2300, GDT_Float32, nullptr, false, false, true, -150 },
  };
  for (const TestCase& one : cases)
  {
    CHECK_CASE(one.Name);
    const std::string name = WriteRaster(check, folders, one);
    std::vector<std::string> indices;
    for (const bool isRead : { false, true })
    {
      const std::shared_ptr<relevo::RasterPyramid> pyramid = OpenPyramid(check, name);
      CHECK_EQUAL(pyramid->WaitForIndex([]() { return false; }), std::string());
      CHECK(pyramid->IsIndexComplete());
      CheckSaturation(check, *pyramid);
      if (isRead)
      {
        CheckBounds(check, *pyramid, one);
        CheckRanges(check, *pyramid, one);
        if (one.HasHoles)
        {
          CheckOutlines(check, *pyramid, name);
        }
        const std::string index = ReadFile(name + ".relevo-index");
        constexpr std::int64_t memoryOfTwoThreads = 50 << 20;
        for (const auto& [threads, limit] : { std::pair<int, std::int64_t>(1, 0),
               std::pair<int, std::int64_t>(3, memoryOfTwoThreads) })
        {
          CHECK(BuildIndex(check, pyramid->GetFile(), folders.File("BlockErrors.index"), threads,
                  limit) == index);
        }
      }
    }
  }
}

// A plane has no errors, a raster of one row no blocks, and a raster without data no heights.
void TestFlat(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("TerrainPyramidFlat.tif");
  for (int i = 0; i < 4; ++i)
  {
    CHECK_CASE(i);
    const int height = i % 2 == 0 ? 1 : 257;
    const bool hasData = i / 2 == 0;
    RelevoRaster raster = RelevoRaster::MakeSlope(257, height, {}, "");
    if (!hasData)
    {
      raster.NoData = 5.0;
      raster.SetValues([](int, int, int) { return 5.0; });
    }
    CHECK(raster.Write(name));
    const std::shared_ptr<relevo::RasterPyramid> pyramid = OpenPyramid(check, name);
    CHECK_EQUAL(pyramid->WaitForIndex([]() { return false; }), std::string());
    const std::shared_ptr<const BlockErrors> errors = pyramid->GetBlockErrors();
    CHECK_EQUAL(errors->GetRootLevel(), 5);
    for (int level = 0; level <= 5; ++level)
    {
      CHECK_EQUAL(errors->GetSquareError(level, 0, 0), 0.0f);
    }
    const relevo::ElevationRanges::Range range =
      pyramid->GetElevationRanges()->Get(0, { { 0.0, 256.0 } }, { { 0.0, height - 1.0 } });
    CHECK_EQUAL(range[0] <= range[1], hasData);
  }
}

// As long as the index is built, there are estimates.
void TestEstimates(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster =
    RelevoRaster::MakeSlope(700, 500, { 7.0, 0.001, 0.0, 60.0, 0.0, -0.001 }, "EPSG:4326", 100.0);
  const std::string name = folders.File("TerrainPyramidEstimates.tif");
  CHECK(raster.Write(name));
  std::string error;
  const std::unique_ptr<relevo::PyramidFile> file = relevo::PyramidFile::Open(name, error);
  CHECK(file != nullptr);
  // 0.001 degrees of latitude are 111 m, those of longitude 56 m.
  CHECK_NEAR(relevo::GetSampleDistance(file->Describe()), 83.7, 1.0);
  const std::array<double, 2> range = relevo::EstimateRange(*file);
  CHECK_EQUAL(range[0], 100.0);
  CHECK_EQUAL(range[1], 100.0 + 699.0 + 499.0);
}
}

int TestTerrainPyramidBlockErrors(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestFlat(check, folders);
  TestEstimates(check, folders);
  TestCases(check, folders);
  return check.GetResult();
}
