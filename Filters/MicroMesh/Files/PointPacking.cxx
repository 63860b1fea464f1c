// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/PointPacking.h"

#include "Files/ArrayPacking.h"
#include "Files/BitList.h"
#include "Files/LittleEndian.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace relevo
{
namespace
{
constexpr std::size_t SizeOfExponent = 2;
constexpr int BitsOfInteger = 32;
constexpr std::size_t SizeOfInteger = 4;
constexpr double MostInteger = 1 << 30;

using Point = std::array<double, 3>;
using Integers = std::array<std::int32_t, 3>;

// The exponent of the lowest bit of all coordinates.
int FindLowestBit(const Point& point)
{
  constexpr int mantissa = 53;
  int lowest = 2000;
  for (double coordinate : point)
  {
    int exponent = 0;
    const double fraction = std::frexp(coordinate, &exponent);
    if (fraction != 0.0 && std::isfinite(fraction))
    {
      auto bits = static_cast<std::int64_t>(std::ldexp(fraction, mantissa));
      exponent -= mantissa;
      for (; (bits & 1) == 0; bits /= 2)
      {
        ++exponent;
      }
      lowest = std::min(lowest, exponent);
    }
  }
  return lowest;
}

// An exponent at which most points have integers.
int FindExponent(vtkDataArray* points)
{
  std::vector<int> exponents;
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    Point point{};
    points->GetTuple(i, point.data());
    exponents.push_back(FindLowestBit(point));
  }
  if (exponents.empty())
  {
    return 0;
  }
  const auto place = exponents.begin() + static_cast<std::ptrdiff_t>(exponents.size() / 4);
  std::nth_element(exponents.begin(), place, exponents.end());
  return *place;
}

bool ToIntegers(const Point& point, int exponent, Integers& integers)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double value = std::ldexp(point[c], -exponent);
    if (!(std::abs(value) < MostInteger) || std::floor(value) != value)
    {
      return false;
    }
    integers[c] = static_cast<std::int32_t>(value);
    const double again = std::ldexp(double(integers[c]), exponent);
    if (std::memcmp(&again, &point[c], sizeof(again)) != 0) // -0
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkDataArray> MakeOthers(vtkDataArray* points)
{
  auto others = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(points->GetDataType()));
  others->SetNumberOfComponents(3);
  return others;
}
}

std::vector<int> FindFirstPoints(vtkDataArray* points)
{
  const auto number = static_cast<std::size_t>(points->GetNumberOfTuples());
  std::vector<Point> places(number);
  std::vector<int> order(number);
  for (std::size_t i = 0; i < number; ++i)
  {
    points->GetTuple(static_cast<vtkIdType>(i), places[i].data());
    order[i] = static_cast<int>(i);
  }
  const auto compare = [&](int a, int b)
  {
    return std::memcmp(places[static_cast<std::size_t>(a)].data(),
      places[static_cast<std::size_t>(b)].data(), sizeof(Point));
  };
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const int difference = compare(a, b);
      return difference != 0 ? difference < 0 : a < b;
    });
  std::vector<int> firsts(number);
  for (std::size_t i = 0; i < number; ++i)
  {
    const bool isSame = i > 0 && compare(order[i - 1], order[i]) == 0;
    firsts[static_cast<std::size_t>(order[i])] =
      isSame ? firsts[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return firsts;
}

std::string PackPoints(vtkDataArray* points, const std::vector<int>& firsts)
{
  const auto number = static_cast<std::size_t>(points->GetNumberOfTuples());
  const int exponent = FindExponent(points);
  std::vector<std::uint64_t> references;
  std::vector<int> places(number, 0); // of points that are the first ones
  std::string bits;
  const vtkSmartPointer<vtkDataArray> others = MakeOthers(points);
  std::array<std::vector<std::uint64_t>, 3> differences;
  Integers last{};
  int numberOfPlaces = 0;
  for (std::size_t i = 0; i < number; ++i)
  {
    const auto first = static_cast<std::size_t>(firsts[i]);
    if (first != i)
    {
      references.push_back(static_cast<std::uint64_t>(numberOfPlaces - places[first]));
      continue;
    }
    references.push_back(0);
    places[i] = numberOfPlaces++;
    Point point{};
    Integers integers{};
    points->GetTuple(static_cast<vtkIdType>(i), point.data());
    const bool isInteger = ToIntegers(point, exponent, integers);
    AppendBit(!isInteger, static_cast<std::size_t>(places[i]), bits);
    if (!isInteger)
    {
      others->InsertNextTuple(static_cast<vtkIdType>(i), points);
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::int32_t difference = integers[c] - last[c]; // less than 2^31
      const std::uint32_t doubled = static_cast<std::uint32_t>(difference) << 1;
      differences[c].push_back(difference < 0 ? ~doubled : doubled);
    }
    last = integers;
  }
  std::string bytes;
  AppendNumber(bytes, static_cast<std::uint16_t>(exponent), SizeOfExponent);
  PackNumbers(references, BitsOfInteger, bytes);
  bytes += bits;
  for (const std::vector<std::uint64_t>& ofCoordinate : differences)
  {
    PackNumbers(ofCoordinate, BitsOfInteger, bytes);
  }
  return bytes + PackArray(others, FindBits(others));
}

bool UnpackPoints(std::string_view bytes, vtkDataArray* points)
{
  const auto number = static_cast<std::size_t>(points->GetNumberOfTuples());
  const int exponent = static_cast<std::int16_t>(TakeNumber(bytes, SizeOfExponent));
  if (bytes.size() / SizeOfInteger < number)
  {
    return false;
  }
  std::vector<std::uint64_t> references(number);
  UnpackNumbers(bytes, BitsOfInteger, references);
  const auto numberOfPlaces =
    static_cast<std::size_t>(std::count(references.begin(), references.end(), 0u));
  const std::string_view bits = bytes.substr(0, GetBitListSize(numberOfPlaces));
  if (bits.size() != GetBitListSize(numberOfPlaces))
  {
    return false;
  }
  bytes.remove_prefix(bits.size());
  std::size_t numberOfOthers = 0;
  for (std::size_t i = 0; i < numberOfPlaces; ++i)
  {
    numberOfOthers += IsBitSet(bits, i) ? 1 : 0;
  }
  const std::size_t numberOfIntegers = numberOfPlaces - numberOfOthers;
  const std::size_t sizeOfOther = 3 * static_cast<std::size_t>(points->GetDataTypeSize());
  if (bytes.size() != 3 * SizeOfInteger * numberOfIntegers + sizeOfOther * numberOfOthers)
  {
    return false;
  }
  std::array<std::vector<std::uint64_t>, 3> differences;
  for (std::vector<std::uint64_t>& ofCoordinate : differences)
  {
    ofCoordinate.resize(numberOfIntegers);
    UnpackNumbers(bytes, BitsOfInteger, ofCoordinate);
  }
  const vtkSmartPointer<vtkDataArray> others = MakeOthers(points);
  others->SetNumberOfTuples(static_cast<vtkIdType>(numberOfOthers));
  UnpackArray(bytes, FindBits(others), others);
  std::array<std::uint32_t, 3> last{};
  std::vector<vtkIdType> places; // the points that are the first ones
  std::size_t next = 0;
  vtkIdType nextOther = 0;
  for (std::size_t i = 0; i < number; ++i)
  {
    const auto index = static_cast<vtkIdType>(i);
    if (references[i] > places.size())
    {
      return false;
    }
    if (references[i] > 0)
    {
      const auto back = static_cast<std::size_t>(references[i]);
      points->SetTuple(index, places[places.size() - back], points);
      continue;
    }
    places.push_back(index);
    if (IsBitSet(bits, places.size() - 1))
    {
      points->SetTuple(index, nextOther++, others);
      continue;
    }
    Point point{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto doubled = static_cast<std::uint32_t>(differences[c][next]);
      last[c] += (doubled & 1) != 0 ? ~(doubled >> 1) : doubled >> 1;
      point[c] = std::ldexp(double(static_cast<std::int32_t>(last[c])), exponent);
    }
    points->SetTuple(index, point.data());
    ++next;
  }
  return true;
}
}
