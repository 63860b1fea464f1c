// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainDraping
 * @brief   lays the cells of polydata on a terrain
 *
 * Lines are split where the surface bends. Polygons are cut along its triangles. Parts without a
 * surface are left out.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainDraping_h
#define TerrainDraping_h

#include "Draping/DrapedOutput.h"
#include "Draping/DrapedSurface.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

class vtkPolyData;

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT TerrainDraping
{
public:
  struct Settings
  {
    bool IsMirrored = false; // whether columns and rows are clockwise, seen from above
    double Offset = 0.0;     // in world units
    /// The columns and rows of 360 degrees of longitude, or 0.
    MapPosition Period = { { 0.0, 0.0 } };
    vtkIdType MaximumCells = vtkIdType(1) << 24;
    std::function<bool()> IsAborted = [] { return false; };
  };

  /// The positions of the points of the input, NaN for those that do not lie on the map.
  TerrainDraping(DrapedSurface& surface, const Settings& settings, vtkPolyData* input,
    std::vector<MapPosition> positions);

  enum class Result
  {
    Done,
    Aborted,
    TooManyCells // more than Settings::MaximumCells
  };
  Result Run(vtkPolyData* output);

  /// Whether parts of the input have been left out, because there is no surface.
  bool HasLeftOut() const { return this->LeftOut; }

private:
  using Ids = std::vector<vtkIdType>;
  // A position that is shifted by whole periods.
  struct Place
  {
    vtkIdType Id = 0;
    int Shift = 0;
    MapPosition Position;
  };
  using Places = std::vector<Place>;
  struct Line;
  struct Fragments;

  MapPosition Shift(const MapPosition& position, int periods) const;
  Place Move(const Place& place, int periods) const;
  Places Unroll(const Ids& ids) const;
  std::pair<int, int> FindCopies(const Places& places) const;
  MapPosition GetPosition(vtkIdType id) const;
  bool IsToStop();

  void DrapePoints(const Ids& ids, vtkIdType cell);
  void DrapeLine(const Ids& ids, vtkIdType cell);
  void DrapePolygon(const Ids& ids, vtkIdType cell);
  void DrapeStrip(const Ids& ids, vtkIdType cell);
  bool FindPoint(const MapPosition& position, SurfacePoint& point);
  vtkIdType AddVertex(const Place& place, const SurfacePoint& point);
  void AddSegment(Line& line, const Place& start, const Place& end);
  void EndLine(Line& line);
  void DrapeTriangle(const std::array<Place, 3>& corners, Fragments& fragments);
  void AddFragment(const SurfaceTriangle& triangle, const MapBox& box,
    const std::array<Place, 3>& corners, Fragments& fragments);

  DrapedSurface& Surface;
  Settings Current;
  vtkPolyData* Input;
  std::vector<MapPosition> Positions;
  DrapedOutput Output;
  std::map<std::pair<vtkIdType, int>, vtkIdType> Vertices; // points of the output
  std::vector<TerrainPatch::Piece> Pieces;
  std::vector<MapPosition> Polygon;
  Ids PolygonPoints;
  bool LeftOut = false;
  Result State = Result::Done;
};
}

#endif
