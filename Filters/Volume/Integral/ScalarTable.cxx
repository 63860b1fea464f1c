// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/ScalarTable.h"

#include "Integral/FillValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
template <typename T>
void Spread(std::vector<T>& values, size_t count, size_t from, size_t to)
{
  std::vector<T> spread(to * count, T(0));
  for (size_t i = 0; i < count; ++i)
  {
    std::copy_n(values.begin() + from * i, from, spread.begin() + to * i);
  }
  values = std::move(spread);
}

bool IsFloat(double value)
{
  return std::isnan(value) || static_cast<double>(static_cast<float>(value)) == value;
}
}

bool ScalarTable::AreFinite() const
{
  const auto isFinite = [](double value) { return std::isfinite(value); };
  return std::all_of(this->Floats.begin(), this->Floats.end(), isFinite) &&
    std::all_of(this->Doubles.begin(), this->Doubles.end(), isFinite);
}

std::vector<double> ScalarTable::ReplaceFillValues(size_t first)
{
  std::vector<double> all;
  for (size_t c = 0; c < this->Width; ++c)
  {
    const std::vector<double> found = FindFillValues(
      this->Count - first, [&](size_t i) { return this->GetValue(this->Width * (first + i) + c); });
    for (size_t i = first; i < this->Count && !found.empty(); ++i)
    {
      const size_t index = this->Width * i + c;
      if (!IsMissing(this->GetValue(index), found))
      {
        continue;
      }
      if (this->IsWide)
      {
        this->Doubles[index] = std::numeric_limits<double>::quiet_NaN();
      }
      else
      {
        this->Floats[index] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

void ScalarTable::push_back(const Scalars& scalars)
{
  size_t width = scalars.size();
  while (width > this->Width && scalars[width - 1] == 0.0)
  {
    --width;
  }
  this->AddComponents(width);
  if (!this->IsWide && !std::all_of(scalars.begin(), scalars.begin() + this->Width, IsFloat))
  {
    this->StoreDoubles();
  }
  for (size_t c = 0; c < this->Width; ++c)
  {
    if (this->IsWide)
    {
      this->Doubles.push_back(scalars[c]);
    }
    else
    {
      this->Floats.push_back(static_cast<float>(scalars[c]));
    }
  }
  ++this->Count;
}

void ScalarTable::Resize(size_t count)
{
  this->Count = count;
  this->Floats.resize(this->IsWide ? 0 : this->Width * count, 0.0f);
  this->Doubles.resize(this->IsWide ? this->Width * count : 0, 0.0);
}

void ScalarTable::Prepare(size_t count, int numberOfComponents)
{
  this->AddComponents(static_cast<size_t>(numberOfComponents));
  const size_t size = this->Width * (this->Count + count);
  if (this->IsWide)
  {
    this->Doubles.reserve(size);
  }
  else
  {
    this->Floats.reserve(size);
  }
}

void ScalarTable::AddComponents(size_t width)
{
  if (width > this->Width)
  {
    Spread(this->Floats, this->IsWide ? 0 : this->Count, this->Width, width);
    Spread(this->Doubles, this->IsWide ? this->Count : 0, this->Width, width);
    this->Width = width;
  }
}

void ScalarTable::StoreDoubles()
{
  this->Doubles.reserve(this->Floats.capacity());
  this->Doubles.assign(this->Floats.begin(), this->Floats.end());
  std::vector<float>().swap(this->Floats);
  this->IsWide = true;
}
}
