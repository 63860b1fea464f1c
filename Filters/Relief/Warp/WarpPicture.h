// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpPicture
 * @brief   what a warp draws into: the nearest surface at each texel of the relief's plane
 *
 * Private to the module's own sources.
 */
#ifndef WarpPicture_h
#define WarpPicture_h

#include <memory>
#include <vector>

namespace relevo
{
class Relief;
class WarpSource;

/// A place of the source's surface, between four of its texels.
struct WarpPlace
{
  int Row;
  float Fraction;  // of the way to the next row
  int LowerColumn; // in the row
  float LowerFraction;
  int UpperColumn; // in the next row
  float UpperFraction;
  double Height;
};

class WarpPicture
{
public:
  /// Arrays of the size of a relief; normals may be nullptr.
  void SetArrays(float* depths, unsigned char* colors, float* normals);
  /// Arrays of its own, unless it has some.
  void Allocate(const Relief& relief);

  void Begin(const Relief& relief);
  /// Empties a row, which Draw() does as well when it first meets it.
  void Clear(int row);
  void Draw(const WarpSource& source, int column, int row, const WarpPlace& place);

  /// Takes from another picture what is nearer: where depths are equal, this one's stays.
  void Merge(const WarpPicture& other, int row);
  /// Where nothing was seen, colours and normals are 0.
  void Finish(int row);

private:
  void DrawColor(const WarpSource& source, size_t index, const WarpPlace& place);
  void Copy(const WarpPicture& other, size_t first, size_t number);

  int Width = 0;
  int NumberOfColorComponents = 0;
  float* Depths = nullptr;
  unsigned char* Colors = nullptr;
  float* Normals = nullptr;
  std::vector<unsigned char> IsRowDrawn;
  size_t OwnSize = 0;
  std::unique_ptr<float[]> OwnDepths;
  std::unique_ptr<unsigned char[]> OwnColors;
  std::unique_ptr<float[]> OwnNormals;
};
}

#endif
