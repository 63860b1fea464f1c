// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpPicture.h"

#include "Warp/WarpSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// The texels around a point and their weights.
struct Neighbors
{
  Neighbors(const WarpSource& source, const WarpPlace& place)
  {
    const int upperRow = place.Row + (place.Fraction > 0.0f ? 1 : 0);
    this->Set(0, source, place.LowerColumn, place.LowerFraction, place.Row, 1.0f - place.Fraction);
    this->Set(2, source, place.UpperColumn, place.UpperFraction, upperRow, place.Fraction);
  }

  float Mix(const float* values, int components, int component) const
  {
    const float* value = values + component;
    return this->Weights[0] * value[components * this->Indices[0]] +
      this->Weights[1] * value[components * this->Indices[1]] +
      this->Weights[2] * value[components * this->Indices[2]] +
      this->Weights[3] * value[components * this->Indices[3]];
  }

  // Returns fixed-point weights for bytes, where 65536 is 1.
  void GetWholeWeights(unsigned int weights[4]) const
  {
    for (int i = 0; i < 4; ++i)
    {
      weights[i] = static_cast<unsigned int>(this->Weights[i] * 65536.0f);
    }
  }

  unsigned char MixWhole(
    const unsigned char* value, int components, const unsigned int weights[4]) const
  {
    return static_cast<unsigned char>(
      (weights[0] * value[components * this->Indices[0]] +
        weights[1] * value[components * this->Indices[1]] +
        weights[2] * value[components * this->Indices[2]] +
        weights[3] * value[components * this->Indices[3]] + 32768u) >>
      16);
  }

  bool IsOne() const
  {
    return std::any_of(
      this->Weights, this->Weights + 4, [](float weight) { return weight == 1.0f; });
  }

  size_t Indices[4];
  float Weights[4];

private:
  void Set(int first, const WarpSource& source, int column, float fraction, int row, float weight)
  {
    this->Indices[first] = source.GetIndex(column, row);
    this->Indices[first + 1] = this->Indices[first] + (fraction > 0.0f ? 1 : 0);
    this->Weights[first] = weight * (1.0f - fraction);
    this->Weights[first + 1] = weight * fraction;
  }
};
}

void WarpPicture::SetArrays(float* depths, unsigned char* colors, float* normals)
{
  this->Depths = depths;
  this->Colors = colors;
  this->Normals = normals;
}

void WarpPicture::Allocate(const Relief& relief)
{
  const size_t texels = relief.GetNumberOfTexels();
  const size_t colors = texels * relief.GetNumberOfColorComponents();
  const size_t normals = relief.GetNormals() ? 3 * texels : 0;
  const size_t size = sizeof(float) * (texels + normals) + colors;
  if (this->OwnSize != size)
  {
    this->OwnSize = 0;
    this->OwnDepths.reset(new float[texels]);
    this->OwnColors.reset(new unsigned char[colors]);
    this->OwnNormals.reset(normals ? new float[normals] : nullptr);
    this->OwnSize = size;
  }
  this->SetArrays(this->OwnDepths.get(), this->OwnColors.get(), this->OwnNormals.get());
  this->IsRowDrawn.resize(relief.GetHeight());
}

void WarpPicture::Begin(const Relief& relief)
{
  this->Width = relief.GetWidth();
  this->NumberOfColorComponents = relief.GetNumberOfColorComponents();
  this->IsRowDrawn.assign(relief.GetHeight(), 0);
}

void WarpPicture::Clear(int row)
{
  float* depths = this->Depths + static_cast<size_t>(row) * this->Width;
  std::fill(depths, depths + this->Width, std::numeric_limits<float>::quiet_NaN());
  this->IsRowDrawn[row] = 1;
}

void WarpPicture::Draw(const WarpSource& source, int column, int row, const WarpPlace& place)
{
  if (!this->IsRowDrawn[row])
  {
    this->Clear(row);
  }
  const size_t index = source.GetIndex(column, row);
  const auto depth = static_cast<float>(source.GetRelief().ToDepth(place.Height));
  if (!(depth >= this->Depths[index])) // also true if the old depth is NaN
  {
    this->Depths[index] = depth;
    this->DrawColor(source, index, place);
  }
}

inline void WarpPicture::DrawColor(const WarpSource& source, size_t index, const WarpPlace& place)
{
  const Relief& relief = source.GetRelief();
  const Neighbors neighbors(source, place);
  const int components = this->NumberOfColorComponents;
  unsigned char* color = this->Colors + components * index;
  unsigned int weights[4];
  neighbors.GetWholeWeights(weights);
  for (int i = 0; i < components; ++i)
  {
    color[i] = neighbors.MixWhole(relief.GetColors() + i, components, weights);
  }
  if (this->Normals)
  {
    vec3 normal;
    for (int i = 0; i < 3; ++i)
    {
      normal[i] = neighbors.Mix(relief.GetNormals(), 3, i);
    }
    const float size = length(normal);
    if (!neighbors.IsOne() && size > 0.0f)
    {
      normal /= size;
    }
    std::copy(&normal.x, &normal.x + 3, this->Normals + 3 * index);
  }
}

void WarpPicture::Copy(const WarpPicture& other, size_t first, size_t number)
{
  std::copy_n(other.Depths + first, number, this->Depths + first);
  const size_t components = this->NumberOfColorComponents;
  std::copy_n(
    other.Colors + components * first, components * number, this->Colors + components * first);
  if (this->Normals)
  {
    std::copy_n(other.Normals + 3 * first, 3 * number, this->Normals + 3 * first);
  }
}

void WarpPicture::Merge(const WarpPicture& other, int row)
{
  if (!other.IsRowDrawn[row])
  {
    return;
  }
  const size_t first = static_cast<size_t>(row) * this->Width;
  if (!this->IsRowDrawn[row])
  {
    this->IsRowDrawn[row] = 1;
    this->Copy(other, first, this->Width);
    return;
  }
  // Copy runs that are as long as possible.
  const auto isNearer = [&](size_t index)
  {
    return other.Depths[index] == other.Depths[index] &&
      !(other.Depths[index] >= this->Depths[index]);
  };
  const size_t end = first + this->Width;
  for (size_t begin = first; begin < end;)
  {
    size_t last = begin;
    while (last < end && isNearer(last))
    {
      ++last;
    }
    if (last > begin)
    {
      this->Copy(other, begin, last - begin);
    }
    begin = last + 1;
  }
}

void WarpPicture::Finish(int row)
{
  if (!this->IsRowDrawn[row])
  {
    this->Clear(row);
  }
  const size_t first = static_cast<size_t>(row) * this->Width;
  const int components = this->NumberOfColorComponents;
  for (size_t index = first; index < first + this->Width; ++index)
  {
    if (this->Depths[index] != this->Depths[index])
    {
      std::fill_n(this->Colors + components * index, components, static_cast<unsigned char>(0));
      if (this->Normals)
      {
        std::fill_n(this->Normals + 3 * index, 3, 0.0f);
      }
    }
  }
}
}
