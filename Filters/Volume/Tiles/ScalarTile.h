// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ScalarTile
 * @brief   composite or additive colours of a tile of pixels, for functions of a single scalar
 *
 * Each cell is prepared once and then intersected with the rays of the pixels inside of its
 * outline. Scalars of hexahedra, wedges and pyramids are cubics along a ray, which are divided into
 * linear segments of the same mean.
 *
 * Private to the module.
 */
#ifndef ScalarTile_h
#define ScalarTile_h

#include "Cells/CellCrossing.h"
#include "Cells/HexahedronCrossing.h"
#include "Integral/AcrossRay.h"
#include "Integral/CurveIntegral.h"
#include "Integral/Ray.h"
#include "Tiles/CellOutline.h"
#include "Tiles/PixelCells.h"

#include <vector>

namespace relevo
{
class ScalarTile
{
public:
  ScalarTile(const CellCrossing& crossing, const PixelCells& pixels, const CurveIntegral& integral,
    bool isAdditive)
    : Crossing(crossing)
    , Pixels(pixels)
    , Integral(integral)
    , IsAdditive(isAdditive)
  {
  }

  /// Computes the colours of the pixels of a tile, in rows. `rays` are the rays of the pixels, in
  /// world coordinates.
  void Cast(int tile, const std::vector<Ray>& rays, std::vector<dvec4>& colors);

private:
  struct Part
  {
    double Begin;
    double End;
    double Front;
    double Back;
    vtkIdType Cell;

    bool operator<(const Part& other) const
    {
      return this->Begin < other.Begin ||
        (this->Begin == other.Begin &&
          (this->End < other.End || (this->End == other.End && this->Cell < other.Cell)));
    }
  };
  /// The ray of a pixel, relative to the middle of the mesh, and its parts.
  struct Pixel
  {
    Ray Way = {};
    AcrossRay Across = AcrossRay(dvec3(0.0, 0.0, 1.0));
    std::vector<Part> Parts;

    /// Written in place, because this is where crossing small cells takes much of the time.
    void Add(double begin, double end, double front, double back, vtkIdType cell)
    {
      this->Parts.emplace_back();
      Part& part = this->Parts.back();
      part.Begin = begin;
      part.End = end;
      part.Front = front;
      part.Back = back;
      part.Cell = cell;
    }
  };

  void AddCell(int cell);
  void AddTetrahedron(int number, const VolumeCells::Cell& cell);
  void AddHexahedron(
    int number, const VolumeCells::Cell& cell, const HexahedronCrossing::Corners& corners);
  bool AddCurve(HexahedronCrossing& crossing,
    const std::array<double, HexahedronCrossing::NumberOfCorners>& scalars, double tolerance,
    int number, Pixel& pixel);
  void AddOther(int number, Pixel& pixel);
  template <typename Visitor>
  void VisitPixels(int number, const Visitor& visit);
  static void Sort(std::vector<Part>& parts);
  dvec4 Blend(Pixel& pixel) const;
  double GetScalar(vtkIdType point) const
  {
    return this->Crossing.GetCells()
      .GetPointScalars()[static_cast<size_t>(point)][static_cast<size_t>(Integral.GetComponent())];
  }

  const CellCrossing& Crossing;
  const PixelCells& Pixels;
  const CurveIntegral& Integral;
  const bool IsAdditive;

  PixelCells::Tile Bounds = {};
  std::vector<Pixel> Rays;
  CellOutline Outline;
  std::vector<RayPart> Others;
};
}

#endif
