// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefTiles
 * @brief   a relief divided into square tiles; tiles without surface are omitted
 *
 * Coordinates are those of texel space, moved and scaled: (c - c0, r - r0, s (w - w0)). (c0, r0,
 * w0) is near the centre. s makes all three units about equally long in world coordinates there,
 * and its sign makes the third coordinate grow away from the viewer of the relief. Private to the
 * module.
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
  /// The number of quads along a tile's side, the same as in the shaders. Neighbours share the
  /// texels of their border.
  static constexpr int Size = 16;
  static constexpr int Texels = Size + 1;
  /// The number of quads along a cell's side, and of cells along a tile's side.
  static constexpr int CellSize = 8;
  static constexpr int Cells = Size / CellSize;

  /// The sides are those of FindReliefSides().
  void Cut(const Relief& relief, const std::vector<unsigned char>& sides);

  int GetNumberOfTiles() const { return static_cast<int>(this->Places.size()); }

  /// Return the matrix from coordinates of the tiles to the world; points of the surface have a
  /// positive fourth coordinate.
  const dmat4& GetToWorld() const { return this->ToWorld; }
  /// Convert a height of texel space to these coordinates, or a depth to a height.
  double ToScaled(double height) const { return this->HeightScale * (height - this->HeightOffset); }
  double ToHeight(double depth) const
  {
    // in perspective, the inverse depth
    return this->ToScaled(this->HeightScale < 0.0 ? 1.0 / depth : depth);
  }
  double GetHeightScale() const { return this->HeightScale; }
  /// Return the column and row at c = r = 0.
  const ivec2& GetFirst() const { return this->First; }
  /// Return the bounds of the surface in world coordinates; minimum > maximum if there is no
  /// surface.
  const double* GetBounds() const { return this->Bounds; }

  /// Return whether a texel of the surface has a translucent colour.
  bool IsTranslucent() const { return this->Translucent; }

  /// Return, for each tile, the first column and row, and the smallest and largest height.
  const std::vector<vec4>& GetPlaces() const { return this->Places; }
  /// Return, for each tile, 8 integers for two rows of quads each: bit (r % 2) 16 + c is set if
  /// there is a quad.
  const std::vector<unsigned int>& GetQuads() const { return this->Quads; }
  /// Return, for each cell of each tile, the smallest and largest height; smallest > largest for no
  /// surface.
  const std::vector<float>& GetRanges() const { return this->Ranges; }

  /// The highest level. At a level, triangles of half a tile have Size / 2^level quads along a
  /// side.
  static constexpr int HighestLevel = 4;
  /// Return, for each tile and each level 0, 1..., the deviation of the triangles from the surface.
  /// It is infinite for tiles with missing quads, which need the highest level.
  const std::vector<float>& GetDeviations() const { return this->Deviations; }
  /// Return, for each tile, the tiles to the right and above, or -1.
  const std::vector<ivec2>& GetNeighbors() const { return this->Neighbors; }

  /// Return squares of Size x Size quads, row by row, with the indices of their tiles, or -1.
  const ivec2& GetGridSize() const { return this->GridSize; }
  const std::vector<int>& GetGrid() const { return this->Grid; }

  /// Return the layout of textures, which contain the tiles row by row.
  int GetTilesPerRow() const { return this->TilesPerRow; }
  ivec2 GetTextureSize() const;
  const std::vector<float>& GetHeights() const { return this->Heights; }
  /// Return four components per texel; texels are opaque if the relief has three.
  const std::vector<unsigned char>& GetColors() const { return this->Colors; }
  /// Return octahedral normals, two components per texel; empty if the relief has none.
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
