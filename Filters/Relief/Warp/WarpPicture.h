// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpPicture
 * @brief   output of a warp: the nearest surface at each texel of the relief's plane
 *
 * Private to the module.
 */
#ifndef WarpPicture_h
#define WarpPicture_h

#include <memory>
#include <vector>

namespace relevo
{
class Relief;
class WarpSource;

/// A point of the source's surface, between four texels.
struct WarpPlace
{
  int Row;
  float Fraction;  // fraction towards the next row
  int LowerColumn; // in the row
  float LowerFraction;
  int UpperColumn; // in the next row
  float UpperFraction;
  double Height;
};

class WarpPicture
{
public:
  /// Sets arrays of the size of the relief. `normals` may be nullptr.
  void SetArrays(float* depths, unsigned char* colors, float* normals);
  /// Allocates arrays if none are set.
  void Allocate(const Relief& relief);

  void Begin(const Relief& relief);
  /// Clears a row. Draw() does this too, when it draws to the row for the first time.
  void Clear(int row);
  void Draw(const WarpSource& source, int column, int row, const WarpPlace& place);

  /// Copies nearer texels from another image. At equal depth, this image keeps its texel.
  void Merge(const WarpPicture& other, int row);
  /// Sets colours and normals to 0 where there is no surface.
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
