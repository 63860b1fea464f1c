// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Imagery/WarpedImagery.h"

#include "Geodesy/GDALSession.h"
#include "Raster/ImageryTransformer.h"
#include "Raster/RasterFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace relevo
{
namespace
{
constexpr int TexelsPerRow = TerrainTile::Stride;
constexpr int Components = ImageryPicture::NumberOfComponents;

// The overlap of raster and imagery is searched at this many points per side.
constexpr int PointsPerSide = 65;

// Derivatives are differences over this length, in samples.
constexpr double Difference = 1.0 / 16.0;

// Without overviews, a picture of a larger image takes seconds.
constexpr double LargestWithoutOverviews = 8000.0 * 8000.0; // pixels

std::string DescribeMissingOverviews(GDALDatasetH file)
{
  const int size[2] = { GDALGetRasterXSize(file), GDALGetRasterYSize(file) };
  if (static_cast<double>(size[0]) * size[1] <= LargestWithoutOverviews ||
    GDALGetOverviewCount(GDALGetRasterBand(file, 1)) > 0)
  {
    return "";
  }
  return "it has no overviews, so distant views read all of its " + std::to_string(size[0]) +
    " x " + std::to_string(size[1]) +
    " pixels, which is slow. Write overviews (gdaladdo -r average FILE)";
}

// Longitudes of the raster and of the imagery differ by at most this many turns.
constexpr int TurnsOfLongitude = 2;

bool IsInside(const std::array<double, 2>& position, const std::array<int, 2>& size)
{
  return position[0] >= 0.0 && position[1] >= 0.0 && position[0] <= size[0] &&
    position[1] <= size[1];
}

// Calls a function for points of a grid over an image.
template <typename Function>
void ForGrid(const std::array<int, 2>& size, const Function& function)
{
  for (int i = 0; i < PointsPerSide * PointsPerSide; ++i)
  {
    const double step = 1.0 / (PointsPerSide - 1);
    function(std::array<double, 2>{
      { size[0] * step * (i % PointsPerSide), size[1] * step * (i / PointsPerSide) } });
  }
}

// The pixels of the imagery per pixel of a target along its columns and rows; zeros if they are
// not known.
std::array<double, 2> MeasurePixels(
  const ImageryTransformer& transformer, const std::array<double, 2>& position)
{
  const ImageryTransformer::Point here = transformer.ToImage(position);
  std::array<double, 2> lengths = { { 0.0, 0.0 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    std::array<double, 2> beside = position;
    beside[axis] += Difference;
    const ImageryTransformer::Point there = transformer.ToImage(beside);
    if (here.IsKnown && there.IsKnown)
    {
      const double x = transformer.GetNearest(there.Position[0], here.Position[0]);
      lengths[axis] =
        std::hypot(x - here.Position[0], there.Position[1] - here.Position[1]) / Difference;
    }
  }
  return lengths;
}

// A range of pixels, in samples and with a margin. A sample is at the centre of its pixel.
std::array<double, 2> WidenExtent(const std::array<double, 2>& range, double pixel)
{
  const double margin = 0.02 * (range[1] - range[0]) + pixel;
  return { { range[0] - 0.5 - margin, range[1] - 0.5 + margin } };
}
}

//------------------------------------------------------------------------------
// Datasets

struct WarpedImagery::Handle
{
  std::map<int, ImageryPicture> Pictures; // by overview
};

// A handle for as long as a thread reads.
class WarpedImagery::Lease
{
public:
  explicit Lease(const WarpedImagery& imagery)
    : Imagery(imagery)
  {
    const std::lock_guard<std::mutex> lock(imagery.Mutex);
    if (imagery.Free.empty())
    {
      this->Owned = std::make_unique<Handle>();
    }
    else
    {
      this->Owned = std::move(imagery.Free.back());
      imagery.Free.pop_back();
    }
  }
  ~Lease()
  {
    const std::lock_guard<std::mutex> lock(this->Imagery.Mutex);
    this->Imagery.Free.push_back(std::move(this->Owned));
  }
  Lease(const Lease&) = delete;
  void operator=(const Lease&) = delete;

  Handle& Get() const { return *this->Owned; }

private:
  const WarpedImagery& Imagery;
  std::unique_ptr<Handle> Owned;
};

WarpedImagery::~WarpedImagery()
{
  GDALSession session; // collects what GDAL reports while it closes the file
  this->Free.clear();
}

const ImageryPicture* WarpedImagery::GetPicture(
  Handle& handle, int overview, const GDALSession& session, std::string& error) const
{
  const auto known = handle.Pictures.find(overview);
  if (known != handle.Pictures.end())
  {
    return &known->second;
  }
  ImageryPicture picture;
  const std::array<int, 3> bands =
    this->Options.HasNumbers ? std::array<int, 3>{ { 1, 1, 1 } } : this->Options.Bands;
  if (!picture.Open(this->Options.FileName, bands, this->IsTerrainLocated, overview, session, error,
        !this->Options.HasNumbers))
  {
    error = error.empty() ? session.Messages("GDAL cannot open it") : error;
    return nullptr;
  }
  return &handle.Pictures.emplace(overview, std::move(picture)).first->second;
}

//------------------------------------------------------------------------------
// The imagery and the raster

std::shared_ptr<const WarpedImagery> WarpedImagery::Open(const ImageryOptions& options,
  const RasterDescription& terrain, std::string& warning, std::string& error)
{
  error = FindRasterFileError(options.FileName);
  if (!error.empty())
  {
    return nullptr;
  }
  const std::shared_ptr<WarpedImagery> imagery(new WarpedImagery);
  imagery->Options = options;
  imagery->Size = { { terrain.Width, terrain.Height } };
  imagery->IsTerrainLocated = terrain.Location.System != Georeference::Kind::None;
  GDALSession::ForgetFile(options.FileName); // a server may have failed before
  const FileVersion before(options.FileName);
  GDALSession session;
  auto handle = std::make_unique<Handle>();
  const ImageryPicture* picture = imagery->GetPicture(*handle, -1, session, error);
  if (!picture)
  {
    GDALSession::ForgetFile(options.FileName);
    return nullptr;
  }
  imagery->Version = FileVersion(options.FileName, picture->GetFile());
  if (options.HasNumbers)
  {
    imagery->DescribeNumbers(*picture);
  }
  else
  {
    imagery->Stretch = picture->FindStretch();
  }
  if (picture->IsLocated())
  {
    imagery->Location = terrain.Location;
  }
  else
  {
    imagery->Location.FlipColumns = terrain.Location.FlipColumns;
    imagery->Location.FlipRows = terrain.Location.FlipRows;
  }
  if (imagery->IsTerrainLocated && !picture->HasLocation())
  {
    warning = "it has no georeference, but the terrain has one. It is stretched over the whole "
              "terrain. Give the file a georeference (gdal_translate -a_srs EPSG:... -a_ullr "
              "...)";
  }
  const std::string overviews = DescribeMissingOverviews(picture->GetFile());
  warning += (warning.empty() || overviews.empty() ? "" : ". Moreover, ") + overviews;
  error = imagery->Measure(*picture, session);
  if (before.HasChanged())
  {
    error = "the file has changed while it was opened";
  }
  if (!error.empty())
  {
    return nullptr;
  }
  imagery->Free.push_back(std::move(handle));
  return imagery;
}

void WarpedImagery::DescribeNumbers(const ImageryPicture& picture)
{
  const GDALRasterBandH band = GDALGetRasterBand(picture.GetFile(), 1);
  int isDeclared = 0;
  const double scale = GDALGetRasterScale(band, &isDeclared);
  this->Scale = isDeclared ? scale : 1.0;
  const double offset = GDALGetRasterOffset(band, &isDeclared);
  this->Offset = isDeclared ? offset : 0.0;
  // NetCDF's attribute is more readable than the name of a variable.
  const char* name = GDALGetMetadataItem(band, "long_name", nullptr);
  this->Name = name ? name : GDALGetDescription(band);
  this->Unit = GDALGetRasterUnitType(band);
  double range[2] = { 0.0, 0.0 };
  GDALComputeRasterMinMax(band, true, range);
  this->Range = { { this->Scale * range[0] + this->Offset,
    this->Scale * range[1] + this->Offset } };
  std::sort(this->Range.begin(), this->Range.end());
}

// Returns an image in memory of size x size pixels. The first one's centre is the vertex (column,
// row) of the lattice of a level.
GDALDatasetPointer WarpedImagery::CreateTarget(int level, double column, double row, int size) const
{
  const auto toCoordinates = [this](double x, double y)
  {
    // A sample is at the centre of its pixel.
    const double u = (x + 0.5) / this->Size[0];
    const double v = (y + 0.5) / this->Size[1];
    return this->Location.Coordinates(
      this->Location.FlipColumns ? 1.0 - u : u, this->Location.FlipRows ? 1.0 - v : v);
  };
  const double spacing = std::ldexp(1.0, level);
  const double x = (column - 0.5) * spacing;
  const double y = (row - 0.5) * spacing;
  const std::array<double, 2> corner = toCoordinates(x, y);
  const std::array<double, 2> right = toCoordinates(x + spacing, y);
  const std::array<double, 2> below = toCoordinates(x, y + spacing);
  return ImageryPicture::CreateTarget(size, size,
    { { corner[0], right[0] - corner[0], below[0] - corner[0], corner[1], right[1] - corner[1],
      below[1] - corner[1] } },
    this->Location.WKT);
}

// The columns of the raster after which longitudes repeat; 0 for other coordinate systems.
double WarpedImagery::FindPeriod() const
{
  if (this->Location.System != Georeference::Kind::Geographic || this->Location.AlongU[1] != 0.0 ||
    this->Location.AlongV[0] != 0.0 || this->Location.AlongU[0] == 0.0)
  {
    return 0.0;
  }
  return 360.0 / std::abs(this->Location.AlongU[0] * this->Location.Unit) * this->Size[0];
}

// Finds the extent and the finest level. Returns an error, or "".
std::string WarpedImagery::Measure(const ImageryPicture& picture, const GDALSession& session)
{
  const GDALDatasetPointer samples = this->CreateTarget(0, 0.0, 0.0, 1);
  if (!samples)
  {
    return session.Messages("there is not enough memory for it");
  }
  const ImageryTransformer transformer(picture.GetView(), samples.get());
  if (!transformer.IsValid())
  {
    return session.Messages("its coordinate system cannot be converted to the terrain's");
  }
  const double period = this->FindPeriod();
  const int turns = period > 0.0 ? TurnsOfLongitude : 0;
  const std::array<int, 2> imagerySize = { { GDALGetRasterXSize(picture.GetView()),
    GDALGetRasterYSize(picture.GetView()) } };
  bool overlaps = false;
  bool isBounded = true;
  double pixelsPerSample = 0.0;
  std::array<double, 2> columns = { { std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() } };
  std::array<double, 2> rows = columns;
  const auto measure = [&](const std::array<double, 2>& position)
  {
    overlaps = true;
    if (transformer.IsAtPole(transformer.ToImage(position).Position[1]))
    {
      return;
    }
    const std::array<double, 2> lengths = MeasurePixels(transformer, position);
    pixelsPerSample = std::max({ pixelsPerSample, lengths[0], lengths[1] });
  };
  ForGrid(this->Size,
    [&](const std::array<double, 2>& position)
    {
      const ImageryTransformer::Point point = transformer.ToImage(position);
      if (point.IsKnown && IsInside(point.Position, imagerySize))
      {
        measure(position);
      }
    });
  ForGrid(imagerySize,
    [&](const std::array<double, 2>& position)
    {
      const ImageryTransformer::Point point = transformer.ToTarget(position);
      isBounded = isBounded && point.IsKnown;
      if (point.IsKnown)
      {
        columns = { { std::min(columns[0], point.Position[0]),
          std::max(columns[1], point.Position[0]) } };
        rows = { { std::min(rows[0], point.Position[1]), std::max(rows[1], point.Position[1]) } };
        for (int turn = -turns; turn <= turns; ++turn)
        {
          const std::array<double, 2> turned = { { point.Position[0] + turn * period,
            point.Position[1] } };
          if (IsInside(turned, this->Size))
          {
            measure(turned);
          }
        }
      }
    });
  if (isBounded)
  {
    // Sides of the imagery are curves between the points.
    const double pixel = 2.0 / std::max(pixelsPerSample, 1e-3);
    columns = WidenExtent(columns, pixel);
    rows = WidenExtent(rows, pixel);
  }
  else
  {
    columns = { { 0.0, static_cast<double>(this->Size[0]) } };
    rows = { { 0.0, static_cast<double>(this->Size[1]) } };
  }
  this->SetExtent(columns, rows);
  this->SetFinestLevel(pixelsPerSample);
  return overlaps ? "" : "it does not overlap the terrain";
}

void WarpedImagery::SetExtent(
  const std::array<double, 2>& columns, const std::array<double, 2>& rows)
{
  const double period = this->FindPeriod();
  const int turns = period > 0.0 ? TurnsOfLongitude : 0;
  for (int turn = -turns; turn <= turns; ++turn)
  {
    this->Columns.push_back({ { columns[0] + turn * period, columns[1] + turn * period } });
  }
  this->Rows = rows;
}

void WarpedImagery::SetFinestLevel(double pixelsPerSample)
{
  int root = 0;
  while (std::ldexp(static_cast<double>(TerrainTile::CellsPerTile), root) <
    std::max(this->Size[0], this->Size[1]) - 1)
  {
    ++root;
  }
  // A texel of this level is at most as large as a pixel of the imagery.
  const double level = pixelsPerSample > 0.0 ? std::floor(-std::log2(pixelsPerSample)) : 0.0;
  this->FinestLevel = static_cast<int>(std::clamp<double>(level, TerrainTile::FinestLevel, root));
}

bool WarpedImagery::Covers(int level, int column, int row) const
{
  const double size = std::ldexp(static_cast<double>(TerrainTile::CellsPerTile), level);
  const auto covers = [size](const std::array<double, 2>& range, int index)
  { return index * size <= range[1] && (index + 1) * size >= range[0]; };
  return covers(this->Rows, row) &&
    std::any_of(this->Columns.begin(), this->Columns.end(),
      [&](const std::array<double, 2>& range) { return covers(range, column); });
}

//------------------------------------------------------------------------------
// Tiles

// The texels of a tile that imagery may cover: first column and row, width and height.
std::array<int, 4> WarpedImagery::GetWindow(const ImageryTile& tile) const
{
  const auto toTexels = [&tile](const std::array<double, 2>& range, int index)
  {
    const auto toTexel = [&](double sample)
    {
      return std::ldexp(sample, -tile.Level) -
        static_cast<double>(index) * TerrainTile::CellsPerTile + 1.0;
    };
    return std::array<double, 2>{ { std::clamp(
                                      std::floor(toTexel(range[0])) - 1.0, 0.0, 1.0 * TexelsPerRow),
      std::clamp(std::ceil(toTexel(range[1])) + 2.0, 0.0, 1.0 * TexelsPerRow) } };
  };
  std::array<double, 2> columns = { { 1.0 * TexelsPerRow, 0.0 } };
  for (const std::array<double, 2>& range : this->Columns)
  {
    const std::array<double, 2> texels = toTexels(range, tile.Column);
    if (texels[0] < texels[1])
    {
      columns = { { std::min(columns[0], texels[0]), std::max(columns[1], texels[1]) } };
    }
  }
  const std::array<double, 2> rows = toTexels(this->Rows, tile.Row);
  const auto getFirst = [](const std::array<double, 2>& texels)
  { return static_cast<int>(std::min(texels[0], TexelsPerRow - 1.0)); };
  const auto getSize = [](const std::array<double, 2>& texels)
  { return static_cast<int>(std::max(1.0, texels[1] - texels[0])); };
  return { { getFirst(columns), getFirst(rows), getSize(columns), getSize(rows) } };
}

// Pixels of an image per texel of a tile, in the middle of a window.
std::array<double, 2> WarpedImagery::MeasureReduction(
  const ImageryPicture& picture, GDALDatasetH target, const std::array<int, 4>& window) const
{
  const ImageryTransformer transformer(picture.GetView(), target);
  return transformer.IsValid()
    ? MeasurePixels(transformer, { { window[0] + 0.5 * window[2], window[1] + 0.5 * window[3] } })
    : std::array<double, 2>{ { 0.0, 0.0 } };
}

void WarpedImagery::Convert(const std::vector<float>& values, ImageryTile& tile) const
{
  if (this->Options.HasNumbers)
  {
    tile.Numbers.resize(TerrainTile::NumberOfVertices);
    for (std::size_t i = 0; i < tile.Numbers.size(); ++i)
    {
      const float* components = &values[Components * i];
      tile.Numbers[i] = components[Components - 1] > 127.5f
        ? static_cast<float>(this->Scale * components[0] + this->Offset)
        : std::numeric_limits<float>::quiet_NaN();
    }
    return;
  }
  tile.Colors.resize(values.size());
  for (std::size_t i = 0; i < values.size(); i += Components)
  {
    const double opacity = std::clamp(values[i + Components - 1] / 255.0, 0.0, 1.0);
    for (int j = 0; j < Components; ++j)
    {
      const double value = j == Components - 1 ? 255.0 : this->Stretch(values[i + j]);
      tile.Colors[i + j] = static_cast<unsigned char>(
        opacity > 0.0 ? std::lround(opacity * std::clamp(value, 0.0, 255.0)) : 0);
    }
  }
}

bool WarpedImagery::Read(ImageryTile& tile, std::string& error) const
{
  const Lease lease(*this);
  const GDALSession session;
  const bool isRead = this->ReadTile(lease.Get(), session, tile, error);
  if (this->Version.HasChanged())
  {
    error = "the file has changed since it was opened; open it again";
    return false;
  }
  if (!isRead && GDALSession::IsVirtual(this->Options.FileName))
  {
    lease.Get().Pictures.clear(); // a server may have recovered before the next read
    GDALSession::ForgetFile(this->Options.FileName);
  }
  return isRead;
}

bool WarpedImagery::ReadTile(
  Handle& handle, const GDALSession& session, ImageryTile& tile, std::string& error) const
{
  const ImageryPicture* full = this->GetPicture(handle, -1, session, error);
  if (!full)
  {
    return false;
  }
  const GDALDatasetPointer target = this->CreateTarget(tile.Level,
    static_cast<double>(tile.Column) * TerrainTile::CellsPerTile - 1.0,
    static_cast<double>(tile.Row) * TerrainTile::CellsPerTile - 1.0, TexelsPerRow);
  if (!target)
  {
    error = session.Messages("there is not enough memory for a tile");
    return false;
  }
  const std::array<int, 4> window = this->GetWindow(tile);
  std::array<double, 2> reduction = this->MeasureReduction(*full, target.get(), window);
  const int overview = full->ChooseOverview(std::min(reduction[0], reduction[1]));
  const ImageryPicture* picture = this->GetPicture(handle, overview, session, error);
  if (!picture)
  {
    return false;
  }
  const double factor = static_cast<double>(GDALGetRasterXSize(picture->GetView())) /
    GDALGetRasterXSize(full->GetView());
  reduction = { { factor * reduction[0], factor * reduction[1] } };
  std::vector<float> values(Components * TerrainTile::NumberOfVertices);
  constexpr int bytes = sizeof(float);
  const bool isRead = picture->Warp(target.get(), window, reduction) &&
    GDALDatasetRasterIO(target.get(), GF_Read, 0, 0, TexelsPerRow, TexelsPerRow, values.data(),
      TexelsPerRow, TexelsPerRow, GDT_Float32, Components, nullptr, Components * bytes,
      Components * bytes * TexelsPerRow, bytes) == CE_None;
  picture->ReleaseBlocks();
  if (!isRead || session.HasFileErrors())
  {
    error = session.Messages("it cannot be resampled to the terrain");
    return false;
  }
  this->Convert(values, tile);
  return true;
}
}
