// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeShape
 * @brief   the positions of a raster's samples on the ellipsoid, and bounds of their derivatives
 *
 * A raster of longitude and latitude that covers all longitudes is closed: its first column follows
 * the last. If it ends half a sample before a pole, it is closed there, too: the first row is moved
 * to the pole, and another row at the pole follows the last.
 *
 * Columns and rows are whole numbers at the centres of samples. Private to the modules for
 * terrains.
 */
#ifndef GlobeShape_h
#define GlobeShape_h

#include "Geodesy/GeocentricFrame.h"
#include "Geodesy/GeoidHeights.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT GlobeShape
{
public:
  /// The location and the size of the raster.
  GlobeShape(const Georeference& location, int width, int height);

  const GeocentricFrame& GetFrame() const { return this->Frame; }

  /// The number of columns after which the raster repeats; 0 if it is not closed.
  int GetPeriod() const { return this->Period; }
  /// The number of columns and rows that are drawn, with those that close the raster.
  const std::array<int, 2>& GetDimensions() const { return this->Dimensions; }
  /// The last column and row that are drawn. A closed raster overlaps by one column.
  const std::array<double, 2>& GetEnd() const { return this->End; }
  /// Whether the first row, and the end, is at a pole. What is beyond the end is at the pole, too,
  /// so that nothing has to be clipped.
  bool HasFirstPole() const { return this->FirstPole; }
  bool HasLastPole() const { return this->LastPole; }

  /// The column and row at which faces are clipped.
  std::array<double, 2> GetBorder() const
  {
    return { { this->End[0], this->LastPole ? NoBorder : this->End[1] } };
  }

  /// The cosine of the latitude one row away from a pole; nearly 0 if there are no rows along
  /// circles of latitude.
  double GetPoleCosine() const { return this->PoleCosine; }

  /// The geoid that the heights of the raster refer to.
  const GeoidHeights& GetGeoid() const { return this->Geoid; }

  struct Vertex
  {
    /// On the ellipsoid. Beyond the borders of the raster, the position is extrapolated where the
    /// projection ends. NaN outside of the projection.
    std::array<double, 3> Position;
    std::array<double, 3> Up;
    double Geoid = 0.0; // height above the ellipsoid
    /// Columns and rows per metre to the east, times the cosine of the latitude, and per metre to
    /// the north. They change little from vertex to vertex, also at poles.
    std::array<float, 4> Derivatives;

    /// The world coordinates at a height in metres above the geoid, which is exaggerated already.
    std::array<double, 3> ToWorld(double exaggeratedHeight, double exaggeration) const
    {
      const double height = exaggeratedHeight + exaggeration * this->Geoid;
      return { { this->Position[0] + height * this->Up[0], this->Position[1] + height * this->Up[1],
        this->Position[2] + height * this->Up[2] } };
    }
  };
  /// Thread-safe.
  void Locate(
    std::size_t number, const double* columns, const double* rows, Vertex* vertices) const;

  /// The position on the ellipsoid. Thread-safe.
  std::array<double, 3> GetPosition(double column, double row) const;

  /// Bounds over a part of the raster.
  struct Bounds
  {
    std::array<double, 2> Lengths = { { 0.0, 0.0 } }; // metres per column and per row
    /// Second derivatives by column, by column and row, and by row, in metres: the components along
    /// the vertical and those along the ellipsoid.
    std::array<double, 3> Vertical = { { 0.0, 0.0, 0.0 } };
    std::array<double, 3> Horizontal = { { 0.0, 0.0, 0.0 } };

    void Extend(const Bounds& other);
    /**
     * The distance between a linear interpolation and the ellipsoid in a part of this size, in
     * columns and rows, at most. Distances along the ellipsoid are multiplied by a slope.
     */
    double GetDistance(const std::array<double, 2>& size, double slope = 1.0) const;
  };
  /// For a smaller part, the bounds are the same or smaller.
  Bounds GetBounds(const std::array<double, 2>& columns, const std::array<double, 2>& rows) const;

  /// Points of the ellipsoid under the raster, and the distance of all others from the convex hull
  /// of these, at most.
  const std::vector<GeocentricFrame::Place>& GetNodes() const { return this->Nodes; }
  double GetNodeDistance() const { return this->NodeDistance; }

private:
  static constexpr double NoBorder = 1e9;
  static constexpr int Cells = 64; // per side, of the bounds

  void Close();
  void ToAngles(std::size_t number, double* columns, double* rows, bool isClosed) const;
  void BuildBounds();
  Bounds BuildNode(const double* x, const double* y, const std::array<double, 2>& step);
  void Extrapolate(double column, double row, Vertex& vertex) const;

  GeocentricFrame Frame;
  GeoidHeights Geoid;
  std::array<int, 2> Size;      // of the raster
  std::array<double, 2> Origin; // raster coordinates of sample (0, 0)
  std::array<double, 2> Column; // per column
  std::array<double, 2> Row;    // per row
  int Period = 0;
  std::array<int, 2> Dimensions;
  std::array<double, 2> End;
  bool FirstPole = false;
  bool LastPole = false;
  double FirstRowShift = 0.0; // of the first row, in rows
  double PoleCosine = 1e-6;
  std::vector<std::vector<Bounds>> Levels; // row by row, from Cells to 1 cells per side
  std::vector<GeocentricFrame::Place> Nodes;
  std::vector<std::array<double, 6>> Gradients; // of column and row, per node
  double NodeDistance = 0.0;
  // Projections are slow.
  mutable std::mutex Mutex;
  mutable std::unordered_map<std::uint64_t, std::array<double, 3>> Positions;
};
}

#endif
