// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   AdaptiveTerrain
 * @brief   a terrain that is refined for views, with the tiles that they need
 *
 * Heights are in the unit of the raster. A view looks at the terrain in the frame of
 * GetPlacement(): metres on a map whose origin is the centre of the raster, see MapFrame, or
 * earth-centred metres, see GlobeShape.
 *
 * Private to the modules for terrains.
 */
#ifndef AdaptiveTerrain_h
#define AdaptiveTerrain_h

#include "Bisection/GlobeFaces.h"
#include "Bisection/HeightTileCache.h"
#include "Bisection/HiddenBlock.h"
#include "Bisection/MipmapTiles.h"
#include "Bisection/TerrainFace.h"
#include "Bisection/TerrainShare.h"
#include "Bisection/TerrainView.h"
#include "Geodesy/GlobeShape.h"
#include "Geodesy/MapFrame.h"
#include "Lattice/HeightLattice.h"
#include "Lattice/ImageryLattice.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace relevo
{
class ClosedLattice;

class RELEVOFILTERSTERRAIN_EXPORT AdaptiveTerrain
{
public:
  //@{
  /// The smallest tolerance in pixels and memory limit in bytes that settings accept.
  static constexpr double SmallestTolerance = 0.01;
  static constexpr std::int64_t SmallestMemoryLimit = std::int64_t(1) << 22;
  //@}

  /// The imagery is optional. The frame is the map, or geocentric.
  explicit AdaptiveTerrain(std::shared_ptr<const HeightLattice> lattice,
    std::shared_ptr<const ImageryLattice> imagery = nullptr, bool isGeocentric = false);
  ~AdaptiveTerrain();
  AdaptiveTerrain(const AdaptiveTerrain&) = delete;
  void operator=(const AdaptiveTerrain&) = delete;

  const HeightLattice& GetLattice() const { return *this->Lattice; }
  const ImageryLattice* GetImagery() const { return this->Imagery.get(); }

  /// Why a raster with this location cannot be placed, as a continuation of its name, or "".
  std::string FindLocationError() const;
  const MapFrame& GetFrame() const { return this->Frame; }
  /// The geocentric frame, or nullptr for the map.
  const GlobeShape* GetGlobe() const { return this->Globe.get(); }
  /// The heights at the poles of the globe, or nullptr for the map.
  const ClosedLattice* GetClosed() const { return this->Closed.get(); }
  /// The position of the raster, with heights times the exaggeration.
  TerrainPlacement GetPlacement(double exaggeration) const;
  /// The bounds of all heights in this position.
  std::array<double, 6> GetBounds(double exaggeration) const;

  /**
   * Divide a limit of memory for everything that a terrain needs. Returns the bytes for tiles and
   * their textures; the rest is for the index and for threads that read tiles. If the limit is
   * small, fewer tiles are read at the same time.
   */
  std::int64_t PlanMemory(std::int64_t limit);

  /// The bytes that tiles may use.
  void SetMemoryLimit(std::size_t bytes) { this->Cache.SetMemoryLimit(bytes); }
  /// The number of faces with positions of their own that fit into memory: those of a globe. A
  /// larger error is used if a view needs more.
  void SetMaximumNumberOfGlobeFaces(std::size_t number) { this->MaximumNumberOfFaces = number; }
  std::size_t GetMemorySize() const
  {
    return this->Cache.GetMemorySize() + this->Vertices.GetMemorySize();
  }

  /// Make the terrain a solid whose bottom has this height, in the unit of the raster.
  void SetBase(const std::optional<double>& height) { this->Base = height; }
  const std::optional<double>& GetBase() const { return this->Base; }
  /// Return the point of the bottom below a point in this position.
  std::array<double, 3> ToBase(
    const std::array<double, 3>& world, double exaggeration, double base) const;

  /// Find only the faces of a share, and their tiles. A solid is not divided.
  void SetShare(const std::optional<TerrainShare>& share) { this->Share = share; }
  /// Return the shares of this number of processes for a view, from the index.
  std::vector<TerrainShare> Divide(const TerrainView& view, double tolerance, int number) const;
  /// Forget the larger error that earlier views needed.
  void ForgetReduction() { this->Coarsening = 1.0; }

  /// Also find the height tiles for the shading of pixels. They are read after those of the faces.
  void SetShading(bool isShaded) { this->Shading = isShaded; }

  /**
   * Find the faces that a view needs for a tolerance in pixels, from the tiles that are in memory;
   * others are read in the background. The view must have the placement of this terrain.
   */
  void Select(const TerrainView& view, double tolerance);

  /// The same, but wait for all tiles that fit into memory. Returns false if `isAborted` has
  /// returned true.
  bool SelectAndWait(
    const TerrainView& view, double tolerance, const std::function<bool()>& isAborted);

  //@{
  /// The result, which is valid until the next selection.
  const std::vector<TerrainFace>& GetFaces() const { return this->Faces; }
  /// Tiles for the shading of pixels, and imagery.
  const std::vector<MipmapTiles::Item>& GetShadingTiles() const { return this->ShadingTiles; }
  /// The blocks out of sight, which have no faces.
  const std::vector<HiddenBlock>& GetHiddenBlocks() const { return this->HiddenBlocks; }
  /// The positions of the vertices of the faces; none on a map.
  const std::vector<const GlobeFaces::Vertices*>& GetVertices() const
  {
    return this->Vertices.GetVertices();
  }
  /// See GlobeFaces.
  std::uint64_t GetNumberOfComputedFaces() const
  {
    return this->Vertices.GetNumberOfComputedFaces();
  }
  double GetError() const { return this->Error; } // the largest in pixels, at most
  bool IsComplete() const;
  /// The factor of the tolerance because of the largest number of faces, at least 1.
  double GetReduction() const { return this->Reduction; }
  /// Whether tiles of the faces do not fit into the limit of memory, if no tiles are being read.
  bool LacksMemory() const
  {
    return !this->FacesComplete && this->HasErrors && this->Cache.LacksMemory();
  }
  //@}

  /// Whether another selection for the same view can have another result.
  bool NeedsFrame() const;

  /// The first error of a kind of tiles since the last call, or "". The tile is drawn coarser.
  std::string TakeError(TerrainTile::Kind kind = TerrainTile::Kind::Heights)
  {
    return this->Cache.TakeError(kind);
  }

private:
  std::array<double, 6> GetGlobeBounds(const TerrainPlacement& placement) const;
  ElevationRanges::Range GetRange(const ElevationRanges& ranges) const;
  std::array<double, 2> GetSolidRange() const;
  void SelectOnce(const TerrainView& view, double tolerance);

  std::shared_ptr<const HeightLattice> Lattice;
  std::shared_ptr<const ImageryLattice> Imagery;
  MapFrame Frame;
  std::shared_ptr<const GlobeShape> Globe;
  std::shared_ptr<const ClosedLattice> Closed; // with a globe
  std::array<int, 2> Dimensions;               // columns and rows, with those that close a globe
  HeightTileCache Cache;
  bool Shading = false;
  std::optional<double> Base;
  std::optional<TerrainShare> Share;
  std::vector<TerrainFace> Faces;
  std::vector<MipmapTiles::Item> ShadingTiles;
  std::vector<HiddenBlock> HiddenBlocks;
  GlobeFaces Vertices; // of the faces
  std::size_t MaximumNumberOfFaces = std::numeric_limits<std::size_t>::max();
  double Coarsening = 1.0; // of the tolerance
  double Error = 0.0;
  double Reduction = 1.0;
  bool FacesComplete = false;
  bool Complete = false; // the faces and the imagery
  bool ShadingComplete = true;
  bool HasErrors = false; // whether the errors of the last selection are known
};
}

#endif
