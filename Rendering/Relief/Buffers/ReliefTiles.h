// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefTiles
 * @brief   a relief cut into square tiles, those without surface left out
 *
 * Coordinates are those of texel space moved and scaled: (c - c0, r - r0, s (w - w0)), with (c0,
 * r0, w0) near the middle, s such that all three are about as long in the world there, and of the
 * sign that has the third grow away from the viewer of the relief. Private to the module.
 */
#ifndef ReliefTiles_h
#define ReliefTiles_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

namespace relevo
{
class Relief;

class ReliefTiles
{
public:
  /// Quads along a tile's side; the shaders have it, too. Neighbours share their border's texels.
  static constexpr int Size = 16;
  static constexpr int Texels = Size + 1;
  /// Quads along the side of a cell, and cells along that of a tile.
  static constexpr int CellSize = 8;
  static constexpr int Cells = Size / CellSize;

  /// sides: of FindReliefSides().
  void Cut(const Relief& relief, const std::vector<unsigned char>& sides);

  int GetNumberOfTiles() const { return static_cast<int>(this->Places.size()); }

  /// From the tiles' coordinates to the world; of points of the surface the fourth is positive.
  const dmat4& GetToWorld() const { return this->ToWorld; }
  /// A height of texel space in these coordinates, and that of a depth.
  double ToScaled(double height) const { return this->HeightScale * (height - this->HeightOffset); }
  double ToHeight(double depth) const
  {
    return this->ToScaled(this->HeightScale < 0.0 ? 1.0 / depth : depth); // as in perspective
  }
  double GetHeightScale() const { return this->HeightScale; }
  /// Of c = r = 0.
  const ivec2& GetFirst() const { return this->First; }
  /// Of the surface, in the world: least and largest x, y, z. least > largest where there is none.
  const double* GetBounds() const { return this->Bounds; }

  /// Whether a texel of the surface has a colour that is.
  bool IsTranslucent() const { return this->Translucent; }

  /// For each tile: first column and row, least and largest height.
  const std::vector<vec4>& GetPlaces() const { return this->Places; }
  /// For each tile 8 numbers, of two rows of quads each: bit (r % 2) 16 + c for a quad there.
  const std::vector<unsigned int>& GetQuads() const { return this->Quads; }
  /// For each cell of each tile least and largest height; least > largest for no surface.
  const std::vector<float>& GetRanges() const { return this->Ranges; }

  /// Quads along the sides of half a tile's triangles are Size / 2^level: levels 0 to this.
  static constexpr int HighestLevel = 4;
  /// How far triangles of lower levels are from the surface: for each tile that of levels 0, 1...;
  /// infinite where quads are not there, for which the highest is needed.
  const std::vector<float>& GetDeviations() const { return this->Deviations; }
  /// The tile beside another, to the right and above, or -1; for each tile.
  const std::vector<ivec2>& GetNeighbors() const { return this->Neighbors; }

  /// Squares of Size x Size quads, row after row, and the numbers of tiles in them, or -1.
  const ivec2& GetGridSize() const { return this->GridSize; }
  const std::vector<int>& GetGrid() const { return this->Grid; }

  /// Textures that have a tile after the other, row after row.
  int GetTilesPerRow() const { return this->TilesPerRow; }
  ivec2 GetTextureSize() const;
  const std::vector<float>& GetHeights() const { return this->Heights; }
  /// Four to a texel; opaque where the relief has three.
  const std::vector<unsigned char>& GetColors() const { return this->Colors; }
  /// On an octahedron, two to a texel; empty where the relief has none.
  const std::vector<unsigned short>& GetNormals() const { return this->Normals; }

private:
  void FindFrame(const Relief& relief);
  void FindTiles(const Relief& relief, const std::vector<unsigned char>& sides);
  void FillTile(const Relief& relief, const std::vector<unsigned char>& sides, int tile);
  void FindDeviations(int tile);
  void FindNeighbors(const Relief& relief);
  void FillTexels(const Relief& relief, int tile);

  dmat4 ToWorld = dmat4(1.0);
  ivec2 First = ivec2(0);
  double HeightScale = 1.0;
  double HeightOffset = 0.0;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  bool Translucent = false;
  int TilesPerRow = 1;
  std::vector<ivec2> Origins; // column and row of each tile
  std::vector<vec4> Places;
  std::vector<unsigned int> Quads;
  std::vector<float> Ranges;
  std::vector<float> Deviations;
  std::vector<ivec2> Neighbors;
  ivec2 GridSize = ivec2(0);
  std::vector<int> Grid;
  std::vector<float> Heights;
  std::vector<unsigned char> Colors;
  std::vector<unsigned short> Normals;
};
}

#endif
