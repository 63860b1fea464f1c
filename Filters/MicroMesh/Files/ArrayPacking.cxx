// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ArrayPacking.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <vector>

namespace relevo
{
namespace
{
constexpr int BitsOfByte = 8;
constexpr int SmallBits = 11; // a byte, and half a byte with three bits

std::uint64_t Load(const unsigned char* value, std::size_t width)
{
  const auto get = [value](auto number)
  {
    std::memcpy(&number, value, sizeof(number));
    return static_cast<std::uint64_t>(number);
  };
  return width == 1 ? get(std::uint8_t{})
    : width == 2    ? get(std::uint16_t{})
    : width == 4    ? get(std::uint32_t{})
                    : get(std::uint64_t{});
}

void Store(std::uint64_t number, unsigned char* value, std::size_t width)
{
  const auto put = [value](auto narrow) { std::memcpy(value, &narrow, sizeof(narrow)); };
  if (width == 1)
  {
    put(static_cast<std::uint8_t>(number));
  }
  else if (width == 2)
  {
    put(static_cast<std::uint16_t>(number));
  }
  else if (width == 4)
  {
    put(static_cast<std::uint32_t>(number));
  }
  else
  {
    put(number);
  }
}

std::uint64_t GetMask(int bits)
{
  return bits == 64 ? ~std::uint64_t{} : (std::uint64_t{ 1 } << bits) - 1;
}

}

// Planes of bytes, and for 11 bits a plane of half bytes.
void PackNumbers(const std::vector<std::uint64_t>& values, int bits, std::string& bytes)
{
  for (int shift = 0; shift + BitsOfByte <= bits; shift += BitsOfByte)
  {
    for (std::uint64_t value : values)
    {
      bytes.push_back(static_cast<char>(value >> shift & 255));
    }
  }
  for (std::size_t i = 0; bits == SmallBits && i < values.size(); i += 2)
  {
    const std::uint64_t next = i + 1 < values.size() ? values[i + 1] >> BitsOfByte : 0;
    bytes.push_back(static_cast<char>((values[i] >> BitsOfByte | next << 4) & 255));
  }
}

void UnpackNumbers(std::string_view& bytes, int bits, std::vector<std::uint64_t>& values)
{
  std::fill(values.begin(), values.end(), 0);
  for (int shift = 0; shift + BitsOfByte <= bits; shift += BitsOfByte)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] |= std::uint64_t{ static_cast<unsigned char>(bytes[i]) } << shift;
    }
    bytes.remove_prefix(values.size());
  }
  if (bits == SmallBits)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const auto both = static_cast<unsigned char>(bytes[i / 2]);
      values[i] |= std::uint64_t{ (i % 2 == 0 ? both : both >> 4) & 7u } << BitsOfByte;
    }
    bytes.remove_prefix((values.size() + 1) / 2);
  }
}

bool IsFloating(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}

bool IsPackedType(int type)
{
  return type == VTK_CHAR || type == VTK_SIGNED_CHAR || type == VTK_UNSIGNED_CHAR ||
    type == VTK_SHORT || type == VTK_UNSIGNED_SHORT || type == VTK_INT ||
    type == VTK_UNSIGNED_INT || type == VTK_LONG || type == VTK_UNSIGNED_LONG ||
    type == VTK_LONG_LONG || type == VTK_UNSIGNED_LONG_LONG || type == VTK_ID_TYPE ||
    IsFloating(type);
}

int FindBits(vtkDataArray* array)
{
  const int bits = BitsOfByte * array->GetDataTypeSize();
  if (array->GetDataType() != VTK_SHORT)
  {
    return bits;
  }
  int found = BitsOfByte;
  const auto values = static_cast<const short*>(array->GetVoidPointer(0));
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    const int magnitude = values[i] < 0 ? -1 - values[i] : values[i];
    found = std::max(found, magnitude < 1 << 7 ? 8 : (magnitude < 1 << 10 ? SmallBits : bits));
  }
  return found;
}

std::uint64_t GetPackedSize(int type, int bits, std::uint64_t components, std::uint64_t tuples)
{
  constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  const auto width = static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(type));
  if (components == 0 || tuples > most / width / components)
  {
    throw std::bad_alloc();
  }
  return bits == SmallBits ? components * (tuples + (tuples + 1) / 2)
                           : components * tuples * static_cast<std::uint64_t>(bits / BitsOfByte);
}

std::string PackArray(vtkDataArray* array, int bits)
{
  const auto width = static_cast<std::size_t>(array->GetDataTypeSize());
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  const auto memory = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  const bool hasDifferences = !IsFloating(array->GetDataType());
  std::vector<std::uint64_t> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  std::string bytes;
  for (std::size_t c = 0; c < components; ++c)
  {
    std::uint64_t last = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::uint64_t value = Load(memory + width * (components * i + c), width);
      values[i] = (value - last) & GetMask(bits);
      last = hasDifferences ? value : 0;
    }
    PackNumbers(values, bits, bytes);
  }
  return bytes;
}

void UnpackArray(std::string_view bytes, int bits, vtkDataArray* array)
{
  const auto width = static_cast<std::size_t>(array->GetDataTypeSize());
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  const auto memory = static_cast<unsigned char*>(array->GetVoidPointer(0));
  const bool hasDifferences = !IsFloating(array->GetDataType());
  const bool isShort = array->GetDataType() == VTK_SHORT;
  const std::uint64_t sign = std::uint64_t{ 1 } << (bits - 1);
  std::vector<std::uint64_t> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t c = 0; c < components; ++c)
  {
    UnpackNumbers(bytes, bits, values);
    std::uint64_t last = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::uint64_t value = (last + values[i]) & GetMask(bits);
      last = hasDifferences ? value : 0;
      Store(isShort ? (value ^ sign) - sign : value, memory + width * (components * i + c), width);
    }
  }
}
}
