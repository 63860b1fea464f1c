// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpColumns.h"

#include "Warp/WarpSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Bits for the corners of a quad: in the next column, in the next row.
constexpr int NextColumn = 1;
constexpr int NextRow = 2;

constexpr double NotConnected = std::numeric_limits<double>::quiet_NaN();

// Returns the integers between two numbers, including both.
inline WholeNumbers GetPassed(double first, double second, int end)
{
  WholeNumbers passed(std::min(first, second), std::max(first, second), 0, end);
  const double highest = std::max(first, second);
  if (passed.End < end && passed.End >= 0 && passed.End == highest)
  {
    ++passed.End;
  }
  return passed;
}
}

WarpColumns::WarpColumns(
  const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture)
  : Source(source)
  , Coefficients(coefficients)
  , Picture(picture)
{
}

inline double WarpColumns::GetWeight(double height) const
{
  return 1.0 + this->Coefficients.K3 * (height - this->Coefficients.Plane);
}

void WarpColumns::Warp(int row, const WarpRow& lower, const WarpRow& upper, const WarpStrip& strip,
  unsigned char* isJoined, int first, int end)
{
  for (int position = first; position < end; ++position)
  {
    const bool isNextJoined = strip.AreJoined(this->Source, row, lower, upper, position);
    if (isNextJoined)
    {
      this->Join(row, position, lower, upper);
    }
    if (!isNextJoined || !isJoined[position])
    {
      this->DrawEnd(row, position, lower, isNextJoined ? upper.Rows[position] : NotConnected);
    }
    isJoined[position] = isNextJoined;
  }
  if (strip.FirstFolded < end && strip.EndFolded > first)
  {
    this->WarpFolds(
      row, lower, upper, strip, std::max(first, strip.FirstFolded), std::min(end, strip.EndFolded));
  }
}

void WarpColumns::WarpLast(
  int row, const WarpRow& lower, const unsigned char* isJoined, int first, int end)
{
  for (int position = first; position < end; ++position)
  {
    if (!isJoined[position])
    {
      this->DrawEnd(row, position, lower, NotConnected);
    }
  }
}

inline void WarpColumns::Join(int row, int position, const WarpRow& lower, const WarpRow& upper)
{
  const double first = lower.Rows[position];
  const double second = upper.Rows[position];
  const WholeNumbers passed = GetPassed(first, second, this->Source.GetHeight());
  for (int place = passed.First; place < passed.End; ++place)
  {
    const WarpRow::Sample& one = lower.Samples[position];
    const WarpRow::Sample& other = upper.Samples[position];
    const double fraction = FindFraction(
      place - first, second - place, this->GetWeight(one.Height), this->GetWeight(other.Height));
    this->Picture.Draw(this->Source, position, place,
      { row, static_cast<float>(fraction), one.Column, one.Fraction, other.Column, other.Fraction,
        (1.0 - fraction) * one.Height + fraction * other.Height });
  }
}

// At borders, the surface extends to the nearest integer position, as in the first pass. `other` is
// the position of the next row, or NotConnected.
inline void WarpColumns::DrawEnd(int row, int position, const WarpRow& lower, double other)
{
  const WarpRow::Sample& sample = lower.Samples[position];
  const double place = lower.Rows[position];
  if (!sample.IsValid() || !(place > -0.5 && place < this->Source.GetHeight() - 0.5))
  {
    return;
  }
  const int nearest = static_cast<int>(std::lround(place));
  const bool isPassed =
    other == other && nearest >= std::min(place, other) && nearest <= std::max(place, other);
  if (isPassed ||
    (nearest != place && this->Source.IsInside(sample.Column, row, sample.IsAtColumn())))
  {
    return;
  }
  this->Picture.Draw(this->Source, position, nearest,
    { row, 0.0f, sample.Column, sample.Fraction, sample.Column, 0.0f, sample.Height });
}

// Draws the whole surface at positions where samples are not sufficient.
inline void WarpColumns::WarpFolds(
  int row, const WarpRow& lower, const WarpRow& upper, const WarpStrip& strip, int first, int end)
{
  const int width = this->Source.GetWidth();
  for (int column = 0; column < width; ++column)
  {
    if (!strip.Quads[column])
    {
      continue;
    }
    const double corners[4] = { lower.Columns[column], lower.Columns[column + 1],
      upper.Columns[column], upper.Columns[column + 1] };
    const WholeNumbers passed(
      std::min(std::min(corners[0], corners[1]), std::min(corners[2], corners[3])),
      std::max(std::max(corners[0], corners[1]), std::max(corners[2], corners[3])), first, end);
    for (int position = passed.First; position < passed.End; ++position)
    {
      if (strip.Folded[position])
      {
        this->Cut(row, column, position, corners);
      }
    }
  }
}

// Draws the intersection lines of a quad with a position of a row.
inline void WarpColumns::Cut(int row, int column, int position, const double corners[4])
{
  // In cyclic order.
  constexpr int sides[4][2] = { { 0, NextColumn }, { NextColumn, NextColumn | NextRow },
    { NextColumn | NextRow, NextRow }, { NextRow, 0 } };
  End ends[4];
  int number = 0;
  for (const auto& side : sides)
  {
    if ((corners[side[0]] > position) != (corners[side[1]] > position))
    {
      ends[number] = this->Cross(row, column, position, corners, side[0], side[1]);
      ++number;
    }
  }
  if (number == 2)
  {
    this->Fill(row, column, position, ends[0], ends[1]);
  }
  else if (number == 4)
  {
    // If all four sides are intersected, the sign at the middle decides how to connect them.
    double middle = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      middle += corners[corner] - position;
    }
    const bool isFirstApart = (middle > 0.0) != (corners[0] > position);
    this->Fill(row, column, position, ends[0], ends[isFirstApart ? 3 : 1]);
    this->Fill(row, column, position, ends[2], ends[isFirstApart ? 1 : 3]);
  }
}

inline WarpColumns::End WarpColumns::Cross(
  int row, int column, int position, const double corners[4], int from, int to) const
{
  const auto height = [&](int corner)
  {
    return this->Source.GetHeights(
      row + ((corner & NextRow) != 0))[column + ((corner & NextColumn) != 0)];
  };
  const int first = std::min(from, to);
  const int second = std::max(from, to);
  const double one = height(first);
  const double other = height(second);
  const double fraction = FindFraction(position - corners[first], corners[second] - position,
    this->GetWeight(one), this->GetWeight(other));
  End end;
  end.Height = (1.0 - fraction) * one + fraction * other;
  const bool isAlongRow = (second - first) == NextColumn;
  const double up = isAlongRow ? (first & NextRow) / NextRow : fraction;
  end.Fraction[0] = static_cast<float>(isAlongRow ? fraction : first & NextColumn);
  end.Fraction[1] = static_cast<float>(up);
  end.Place = (row + up + this->Coefficients.K2 * (end.Height - this->Coefficients.Plane)) /
    this->GetWeight(end.Height);
  return end;
}

inline void WarpColumns::Fill(
  int row, int column, int position, const End& first, const End& second)
{
  const WholeNumbers passed = GetPassed(first.Place, second.Place, this->Source.GetHeight());
  for (int place = passed.First; place < passed.End; ++place)
  {
    const double fraction = FindFraction(place - first.Place, second.Place - place,
      this->GetWeight(first.Height), this->GetWeight(second.Height));
    const auto share = static_cast<float>(fraction);
    const float along = (1.0f - share) * first.Fraction[0] + share * second.Fraction[0];
    const float up = (1.0f - share) * first.Fraction[1] + share * second.Fraction[1];
    this->Picture.Draw(this->Source, position, place,
      { row, up, column, along, column, along,
        (1.0 - fraction) * first.Height + fraction * second.Height });
  }
}
}
