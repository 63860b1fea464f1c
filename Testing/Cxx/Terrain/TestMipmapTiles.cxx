// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The tiles for shading contain the levels that the pixels of random views need, and few more.
// Tiles that are missing are requested, coarse ones first. So are those of imagery.
#include "RelevoCheck.h"
#include "RelevoDice.h"

#include "Bisection/MipmapTiles.h"
#include "Lattice/BlockErrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

using relevo::HeightTile;
using relevo::ImageryTile;
using relevo::MipmapTiles;

namespace
{
constexpr int Columns = 5000;
constexpr int Rows = 3000;
constexpr double Spacing = 10.0;
constexpr double PixelsPerUnit = 800.0; // at the distance 1

using Place = std::array<int, 3>; // level, column and row

// Has all tiles, or those from a level on.
class Tiles
  : public relevo::HeightTileSource
  , public relevo::ImageryTileSource
{
public:
  const ImageryTile* GetImagery(
    int level, int column, int row, double error, float& visibility) override
  {
    this->Errors[{ { level, column, row } }] = error;
    visibility = 1.0f;
    ImageryTile& tile = this->MadeImagery[{ { level, column, row } }];
    tile.Level = level;
    tile.Column = column;
    tile.Row = row;
    return level < this->FinestLevel ? nullptr : &tile;
  }

  const HeightTile* Get(int level, int column, int row, double error, float& visibility) override
  {
    this->Errors[{ { level, column, row } }] = error;
    visibility = level == this->FadingLevel ? 0.25f : 1.0f;
    HeightTile& tile = this->Made[{ { level, column, row } }];
    tile.Level = level;
    tile.Column = column;
    tile.Row = row;
    return level < this->FinestLevel ? nullptr : &tile;
  }

  int FinestLevel = 0;
  int FadingLevel = -1;
  std::map<Place, double> Errors;

private:
  std::map<Place, HeightTile> Made;
  std::map<Place, ImageryTile> MadeImagery;
};

// Covers the first columns of the raster.
class Imagery : public relevo::ImageryLattice
{
public:
  static constexpr int FinestLevel = -3;
  static constexpr double LastColumn = 2000.0;

  int GetFinestLevel() const override { return FinestLevel; }
  bool Covers(int level, int column, int) const override
  {
    return std::ldexp(256.0 * column, level) <= LastColumn;
  }
  bool Read(ImageryTile&, std::string&) const override { return false; }
};

relevo::TerrainView MakeView(const std::array<double, 3>& eye)
{
  relevo::TerrainView view;
  relevo::TerrainPlacement placement;
  placement.Column = { { Spacing, 0.0 } };
  placement.Row = { { 0.0, -Spacing } };
  view.SetPerspective(eye, PixelsPerUnit, 1.0);
  view.SetPlacement(placement);
  return view;
}

bool Has(const MipmapTiles& tiles, const Place& place)
{
  return std::any_of(tiles.GetTiles().begin(), tiles.GetTiles().end(),
    [&place](const MipmapTiles::Item& item) {
      return Place{ { item.Tile->Level, item.Tile->Column, item.Tile->Row } } == place;
    });
}

void TestViews(RelevoCheck& check)
{
  RelevoDice dice(4);
  const relevo::ElevationRanges ranges(relevo::ElevationRanges::Range{ { 0.0f, 500.0f } });
  const int root = relevo::BlockErrors::GetRootLevel(Columns, Rows);
  std::size_t finest = 0;
  for (int i = 0; i < 40; ++i)
  {
    CHECK_CASE(i);
    const std::array<double, 3> eye = { { Spacing * Columns * dice.Share(),
      -Spacing * Rows * dice.Share(), std::exp2(8.0 + 8.0 * dice.Share()) } };
    const relevo::TerrainView view = MakeView(eye);
    Tiles source;
    MipmapTiles tiles(Columns, Rows, ranges);
    tiles.Select(view, 1.0, source);
    CHECK(tiles.IsComplete());
    CHECK(Has(tiles, { { root, 0, 0 } }));
    for (int j = 0; j < 200; ++j)
    {
      // Near points are more frequent.
      const double distance = Spacing * Columns * std::exp2(-10.0 * dice.Share());
      const double angle = 6.2832 * dice.Share();
      const double column = eye[0] / Spacing + distance / Spacing * std::cos(angle);
      const double row = -eye[1] / Spacing + distance / Spacing * std::sin(angle);
      if (column < 0.0 || column > Columns - 1.0 || row < 0.0 || row > Rows - 1.0)
      {
        continue;
      }
      const double height = 500.0 * dice.Share();
      const double pixels = PixelsPerUnit * Spacing / std::hypot(distance, eye[2] - height);
      // A pixel cannot cover less than this where the surface is horizontal or the view oblique.
      const int level = std::clamp(static_cast<int>(std::floor(-std::log2(pixels))), 0, root);
      finest += level == 0 ? 1 : 0;
      for (int l = level; l <= std::min(level + 1, root); ++l)
      {
        const double size = std::ldexp(static_cast<double>(HeightTile::CellsPerTile), l);
        CHECK(Has(tiles, { { l, static_cast<int>(column / size), static_cast<int>(row / size) } }));
      }
    }
  }
  CHECK_GREATER(finest, 100);
}

// From above, no tile is finer than pixels need, if they do not need nearly the next finer level.
void TestNumber(RelevoCheck& check)
{
  const relevo::ElevationRanges ranges(relevo::ElevationRanges::Range{ { 0.0f, 0.0f } });
  for (int level = 0; level < 4; ++level)
  {
    CHECK_CASE(level);
    // Pixels cover 1.4 * 2^level samples per side.
    relevo::TerrainView view;
    relevo::TerrainPlacement placement;
    placement.Column = { { Spacing, 0.0 } };
    placement.Row = { { 0.0, -Spacing } };
    view.SetPlacement(placement);
    view.SetParallel(1.0 / (1.4 * std::ldexp(Spacing, level)));
    Tiles source;
    MipmapTiles tiles(Columns, Rows, ranges);
    tiles.Select(view, 1.0, source);
    const auto count = [](double size) { return static_cast<int>(std::ceil(size)); };
    int expected = 0;
    for (int l = level; l <= relevo::BlockErrors::GetRootLevel(Columns, Rows); ++l)
    {
      const double size = std::ldexp(static_cast<double>(HeightTile::CellsPerTile), l);
      expected += count((Columns - 1) / size) * count((Rows - 1) / size);
    }
    CHECK_EQUAL(tiles.GetTiles().size(), expected);
  }
}

void TestMissing(RelevoCheck& check)
{
  const relevo::ElevationRanges ranges(relevo::ElevationRanges::Range{ { 0.0f, 100.0f } });
  const relevo::TerrainView view = MakeView({ { 20000.0, -10000.0, 300.0 } });
  Tiles source;
  source.FinestLevel = 2;
  MipmapTiles tiles(Columns, Rows, ranges);
  constexpr double largest = 0.7;
  tiles.Select(view, largest, source);
  CHECK(!tiles.IsComplete());
  double errors[2] = { 0.0, 0.0 }; // the largest of levels 0 and 5
  for (const auto& [place, error] : source.Errors)
  {
    CHECK(error > 0.0 && error <= largest);
    CHECK_EQUAL(Has(tiles, place), place[0] >= 2);
    if (place[0] > 0 && place[0] < 5)
    {
      const auto parent = source.Errors.find({ { place[0] + 1, place[1] / 2, place[2] / 2 } });
      CHECK(parent != source.Errors.end() && parent->second >= error);
    }
    errors[place[0] == 0 ? 0 : 1] = std::max(errors[place[0] == 0 ? 0 : 1], error);
  }
  CHECK_GREATER(errors[0], 0.0);
  CHECK_EQUAL(errors[1], largest);

  source.FinestLevel = 0;
  source.FadingLevel = 0;
  tiles.Select(view, largest, source);
  CHECK(!tiles.IsComplete());
  for (const MipmapTiles::Item& item : tiles.GetTiles())
  {
    CHECK_EQUAL(item.Visibility, item.Tile->Level == 0 ? 0.25f : 1.0f);
  }
  source.FadingLevel = -1;
  tiles.Select(view, largest, source);
  CHECK(tiles.IsComplete());
  // Nothing is in view.
  relevo::TerrainView away = view;
  std::array<std::array<double, 4>, 6> planes;
  planes.fill({ { 0.0, 0.0, 1.0, -1000.0 } });
  away.SetFrustum(planes);
  tiles.Select(away, largest, source);
  CHECK(tiles.GetTiles().empty() && tiles.IsComplete());
}

// Imagery that is finer than the raster. Each tile is around finer ones, and is wanted more.
void TestImagery(RelevoCheck& check)
{
  const relevo::ElevationRanges ranges(relevo::ElevationRanges::Range{ { 0.0f, 100.0f } });
  constexpr int root = 5; // 256 * 2^5 samples are more than the columns
  for (const double height : { 110.0, 800.0, 6000.0 })
  {
    CHECK_CASE(height);
    const std::array<double, 3> eye = { { 10000.0, -10000.0, height } };
    const relevo::TerrainView view = MakeView(eye);
    Tiles source;
    source.FinestLevel = Imagery::FinestLevel;
    MipmapTiles tiles(Columns, Rows, ranges);
    tiles.SelectImagery(view, Imagery(), source);
    CHECK(tiles.IsComplete());
    CHECK_EQUAL(source.Errors.size(), tiles.GetTiles().size());
    CHECK_EQUAL((source.Errors[{ { root, 0, 0 } }]), std::numeric_limits<double>::infinity());
    // The level below the eye: a step is at most a pixel.
    const double pixels = PixelsPerUnit * Spacing / (height - 100.0);
    const int level =
      std::max(static_cast<int>(std::floor(-std::log2(pixels))), Imagery::FinestLevel);
    int finest = root;
    for (const auto& [place, error] : source.Errors)
    {
      finest = std::min(finest, place[0]);
      CHECK(place[0] <= root && place[0] >= Imagery::FinestLevel);
      CHECK(Imagery().Covers(place[0], place[1], place[2]));
      if (place[0] < root)
      {
        const auto parent = source.Errors.find({ { place[0] + 1, place[1] / 2, place[2] / 2 } });
        CHECK(parent != source.Errors.end() && parent->second >= 1.5 * error);
      }
    }
    CHECK(finest == level || finest == level - 1);
    const double size = std::ldexp(256.0, level);
    CHECK(
      Has(tiles, { { level, static_cast<int>(1000.0 / size), static_cast<int>(1000.0 / size) } }));
  }
  Tiles source;
  source.FinestLevel = 2;
  MipmapTiles tiles(Columns, Rows, ranges);
  tiles.SelectImagery(MakeView({ { 10000.0, -10000.0, 300.0 } }), Imagery(), source);
  CHECK(!tiles.IsComplete());
  CHECK_GREATER(tiles.GetTiles().size(), 3);
}
}

int TestMipmapTiles(int, char*[])
{
  RelevoCheck check;
  TestViews(check);
  TestNumber(check);
  TestMissing(check);
  TestImagery(check);
  return check.GetResult();
}
