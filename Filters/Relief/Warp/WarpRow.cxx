// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpRow.h"

#include "Warp/WarpCoefficients.h"
#include "Warp/WarpSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
// Positions farther away are ignored.
constexpr double Farthest = 1e15;
constexpr WarpRow::Sample NoSample = { 0.0, -1, 0.0f };

bool IsNumber(double value)
{
  return value == value;
}
}

// Functions that are only called in this file are inline, so that they are inlined in loops even if
// symbols of a shared library can be interposed.
void WarpRow::Allocate(int width)
{
  this->Columns.resize(width);
  this->Samples.resize(width);
  this->Rows.resize(width);
  this->Folded.resize(width);
}

void WarpRow::Warp(const WarpSource& source, const WarpCoefficients& coefficients, int row)
{
  this->FindColumns(source.GetHeights(row), coefficients);
  this->FindSamples(source, coefficients, row);
  this->FindRows(coefficients, row);
}

inline void WarpRow::FindColumns(const double* heights, const WarpCoefficients& coefficients)
{
  const int width = static_cast<int>(this->Columns.size());
  double* columns = this->Columns.data();
  const double plane = coefficients.Plane;
  const double k1 = coefficients.K1;
  const double k3 = coefficients.K3;
  for (int column = 0; column < width; ++column)
  {
    const double height = heights[column] - plane;
    const double weight = 1.0 + k3 * height;
    const double place = (column + k1 * height) / weight;
    columns[column] = weight > 0.0 && std::abs(place) < Farthest ? place : NaN;
  }
}

inline void WarpRow::FindSamples(
  const WarpSource& source, const WarpCoefficients& coefficients, int row)
{
  std::fill(this->Samples.begin(), this->Samples.end(), NoSample);
  std::fill(this->Folded.begin(), this->Folded.end(), static_cast<unsigned char>(0));
  const double* heights = source.GetHeights(row);
  const unsigned char* sides = source.GetSides(row);
  const int width = source.GetWidth();
  bool isJoined[2] = { false, false }; // to the previous and the next texel
  for (int column = 0; column < width; ++column)
  {
    isJoined[0] = isJoined[1];
    isJoined[1] = false;
    if (!IsNumber(this->Columns[column]))
    {
      continue;
    }
    if ((sides[column] & RightSide) && IsNumber(this->Columns[column + 1]))
    {
      isJoined[1] = true;
      this->Join(source, coefficients, heights, column);
    }
    this->End(source, heights[column], column, isJoined);
  }
}

// Adds samples at all integer positions between a texel and the next.
inline void WarpRow::Join(
  const WarpSource& source, const WarpCoefficients& coefficients, const double* heights, int column)
{
  const double first = this->Columns[column];
  const double second = this->Columns[column + 1];
  const WholeNumbers passed(std::min(first, second), std::max(first, second), 0, source.GetWidth());
  for (int position = passed.First; position < passed.End; ++position)
  {
    const double firstHeight = heights[column];
    const double secondHeight = heights[column + 1];
    const double fraction = FindFraction(position - first, second - position,
      1.0 + coefficients.K3 * (firstHeight - coefficients.Plane),
      1.0 + coefficients.K3 * (secondHeight - coefficients.Plane));
    this->Put(source, position,
      { (1.0 - fraction) * firstHeight + fraction * secondHeight, column,
        static_cast<float>(fraction) });
  }
}

// At the end of connected texels, the surface extends to the nearest integer position, so that
// isolated texels are visible. A fold may also be at an integer position.
inline void WarpRow::End(const WarpSource& source, double height, int column, bool isJoined[2])
{
  const double place = this->Columns[column];
  if (!(place > -0.5 && place < source.GetWidth() - 0.5))
  {
    return;
  }
  const bool isEnd = !isJoined[0] || !isJoined[1];
  const int position = isEnd ? static_cast<int>(std::lround(place)) : static_cast<int>(place);
  if (!isEnd && position != place)
  {
    return;
  }
  for (int side = 0; side < 2; ++side)
  {
    if (isJoined[side])
    {
      const double other = this->Columns[column + 2 * side - 1];
      if (position >= std::min(place, other) && position < std::max(place, other))
      {
        return;
      }
    }
  }
  this->Put(source, position, { height, column, 0.0f });
}

inline void WarpRow::Put(const WarpSource& source, int position, const Sample& sample)
{
  Sample& here = this->Samples[position];
  if (here.IsValid())
  {
    this->Folded[position] = 1;
    if (!source.IsNearer(sample.Height, here.Height))
    {
      return;
    }
  }
  here = sample;
}

inline void WarpRow::FindRows(const WarpCoefficients& coefficients, int row)
{
  const size_t width = this->Samples.size();
  for (size_t position = 0; position < width; ++position)
  {
    const double height = this->Samples[position].Height - coefficients.Plane;
    this->Rows[position] = (row + coefficients.K2 * height) / (1.0 + coefficients.K3 * height);
  }
}

void WarpStrip::Allocate(int width)
{
  this->Quads.resize(width);
  this->Folded.resize(width);
}

void WarpStrip::Compare(
  const WarpSource& source, int row, const WarpRow& lower, const WarpRow& upper)
{
  const int width = source.GetWidth();
  const unsigned char* sides = source.GetSides(row);
  this->FirstFolded = width;
  this->EndFolded = 0;
  for (int column = 0; column < width; ++column)
  {
    this->Folded[column] = lower.Folded[column] | upper.Folded[column];
    // The sum is NaN if a term is.
    this->Quads[column] = (sides[column] & Quad) &&
      IsNumber(lower.Columns[column] + lower.Columns[column + 1] + upper.Columns[column] +
        upper.Columns[column + 1]);
  }
  bool isLeft = false;
  for (int column = 0; column < width; ++column)
  {
    const bool isRight = this->Quads[column];
    if (isLeft != isRight)
    {
      this->Open(lower.Columns[column], upper.Columns[column]);
    }
    isLeft = isRight;
  }
  const unsigned char* const begin = this->Folded.data();
  const unsigned char* const end = begin + width;
  const unsigned char* const first = std::find(begin, end, 1);
  this->FirstFolded = static_cast<int>(first - begin);
  const unsigned char* last = end;
  while (last != first && last[-1] == 0)
  {
    --last;
  }
  this->EndFolded = static_cast<int>(last - begin);
}

inline void WarpStrip::Open(double first, double second)
{
  const WholeNumbers passed(
    std::min(first, second), std::max(first, second), 0, static_cast<int>(this->Folded.size()));
  for (int position = passed.First; position < passed.End; ++position)
  {
    this->Folded[position] = 1;
  }
}

// Two samples are connected if the intersection of the surface with this position leads from one to
// the other: the surface between them is on one side of the position in one row, and on the other
// side in the other row.
bool WarpStrip::AreJoined(
  const WarpSource& source, int row, const WarpRow& lower, const WarpRow& upper, int position) const
{
  const WarpRow::Sample& one = lower.Samples[position];
  const WarpRow::Sample& other = upper.Samples[position];
  if (!one.IsValid() || !other.IsValid())
  {
    return false;
  }
  const int first = std::min(one.Column, other.Column);
  const int last = std::max(one.GetNextColumn(), other.GetNextColumn());
  if (first == last)
  {
    return (source.GetSides(row)[first] & UpperSide) != 0;
  }
  for (int column = first; column < last; ++column)
  {
    if (!this->Quads[column])
    {
      return false;
    }
  }
  if (one.Column == other.Column)
  {
    return true;
  }
  const bool isLeft = one.Column < other.Column;
  const int begin = (isLeft ? one : other).Column + 1;
  const int end = (isLeft ? other : one).GetNextColumn();
  for (int column = begin; column < end; ++column)
  {
    const bool isBeyond = lower.Columns[column] > position;
    if (isBeyond == (upper.Columns[column] > position) ||
      isBeyond != (lower.Columns[begin] > position))
    {
      return false;
    }
  }
  return true;
}
}
