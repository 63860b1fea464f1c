// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Segments/RaySegments.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>

namespace relevo
{
namespace
{
constexpr std::uint32_t LargestSize = 1u << 15; // of a view, in pixels

// The numbers at the begin of a message.
struct MessageHeader
{
  std::uint32_t Width;
  std::uint32_t Height;
  std::uint32_t FirstColumn; // of the rectangle with segments
  std::uint32_t FirstRow;
  std::uint32_t Columns;
  std::uint32_t Rows;
  std::uint32_t Blending;
  std::uint32_t NumberOfComponents;
  std::uint32_t AreIndependent;
  std::uint32_t HasSteepness;
};

template <typename T>
void Put(const T& value, std::uint8_t*& to)
{
  std::memcpy(to, &value, sizeof(T));
  to += sizeof(T);
}

template <typename T>
T Take(const std::uint8_t*& from)
{
  T value;
  std::memcpy(&value, from, sizeof(T));
  from += sizeof(T);
  return value;
}

// A colour as four integers and a common exponent. Colours are not negative. The largest component
// of a colour is below 2 to the power of the exponent.
template <int ComponentBits, int ExponentBits, int LowestExponent>
struct ColorCode
{
  static constexpr size_t Bytes = (4 * ComponentBits + ExponentBits) / 8;
  static constexpr std::uint32_t LargestInteger = (1u << ComponentBits) - 1;
  static constexpr int HighestExponent = std::min(LowestExponent + (1 << ExponentBits) - 1, 126);
  static_assert((4 * ComponentBits + ExponentBits) % 8 == 0, "there are unused bits");
  static_assert(LowestExponent - ComponentBits >= -126, "small components are not normal floats");

  static float GetPower(int exponent)
  {
    const std::uint32_t bits = static_cast<std::uint32_t>(exponent + 127) << 23;
    float power = 0.0f;
    std::memcpy(&power, &bits, sizeof(power));
    return power;
  }

  static void Put(const float color[4], std::uint8_t*& to)
  {
    const float largest = std::max({ color[0], color[1], color[2], color[3] });
    std::uint32_t bits = 0;
    std::memcpy(&bits, &largest, sizeof(bits));
    const int exponent =
      std::clamp(static_cast<int>((bits >> 23) & 255) - 126, LowestExponent, HighestExponent);
    const float inverse = GetPower(-exponent);
    std::uint64_t word = static_cast<std::uint64_t>(exponent - LowestExponent);
    for (int c = 0; c < 4; ++c)
    {
      const float share = color[c] > 0.0f ? std::min(color[c] * inverse, 1.0f) : 0.0f;
      const auto integer =
        static_cast<std::uint64_t>(share * static_cast<float>(LargestInteger) + 0.5f);
      word |= integer << (ExponentBits + ComponentBits * c);
    }
    for (size_t i = 0; i < Bytes; ++i)
    {
      *to++ = static_cast<std::uint8_t>(word >> (8 * i));
    }
  }

  static void Take(const std::uint8_t*& from, float color[4])
  {
    std::uint64_t word = 0;
    for (size_t i = 0; i < Bytes; ++i)
    {
      word |= static_cast<std::uint64_t>(*from++) << (8 * i);
    }
    const int exponent = static_cast<int>(word & ((1u << ExponentBits) - 1)) + LowestExponent;
    const float scale = GetPower(exponent) / static_cast<float>(LargestInteger);
    for (int c = 0; c < 4; ++c)
    {
      const auto integer = static_cast<std::uint32_t>(word >> (ExponentBits + ComponentBits * c));
      color[c] = scale * static_cast<float>(integer & LargestInteger);
    }
  }
};

// Components of segments are below 4. Those below 2^-25 are 0.
using SegmentColor = ColorCode<11, 4, -13>;
using SumColor = ColorCode<14, 8, -112>;

size_t GetSegmentBytes(const SegmentFormat& format)
{
  return format.IsOrdered()                  ? sizeof(float) + SegmentColor::Bytes
    : format.Blending == BlendMode::Additive ? SumColor::Bytes
                                             : sizeof(float) * format.GetNumberOfValues();
}

// Return the first column and row with segments, and the first behind them.
std::array<int, 4> FindRectangle(const RaySegments& segments)
{
  std::array<int, 4> box = { { segments.Width, segments.Height, 0, 0 } };
  const auto isFilled = [](std::uint8_t count) { return count > 0; };
  for (int row = 0; row < segments.Height; ++row)
  {
    const auto begin = segments.Counts.begin() + static_cast<std::ptrdiff_t>(row) * segments.Width;
    const auto end = begin + segments.Width;
    const auto first = std::find_if(begin, end, isFilled);
    if (first != end)
    {
      const auto last =
        std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(begin), isFilled);
      box = { { std::min(box[0], static_cast<int>(first - begin)), std::min(box[1], row),
        std::max(box[2], static_cast<int>(last.base() - begin)), row + 1 } };
    }
  }
  return box[2] > box[0] ? box : std::array<int, 4>{ { 0, 0, 0, 0 } };
}

bool IsValid(const MessageHeader& header)
{
  return header.Width <= LargestSize && header.Height <= LargestSize &&
    header.Columns <= header.Width && header.FirstColumn <= header.Width - header.Columns &&
    header.Rows <= header.Height && header.FirstRow <= header.Height - header.Rows &&
    header.Blending <= static_cast<std::uint32_t>(BlendMode::IsoSurface) &&
    header.NumberOfComponents >= 1 && header.NumberOfComponents <= MaximumComponents;
}
}

void RaySegments::Reset(int width, int height, const SegmentFormat& format)
{
  *this = RaySegments();
  this->Width = width;
  this->Height = height;
  this->Format = format;
  this->Counts.assign(static_cast<size_t>(width) * height, 0);
}

bool RaySegments::HasLost() const
{
  unsigned int bits = 0;
  for (std::uint8_t count : this->Counts)
  {
    bits |= count;
  }
  return (bits & Lost) != 0;
}

std::vector<std::uint32_t> RaySegments::FindOffsets() const
{
  std::vector<std::uint32_t> offsets(this->Counts.size() + 1);
  std::uint32_t offset = 0;
  for (size_t pixel = 0; pixel < this->Counts.size(); ++pixel)
  {
    offset += static_cast<std::uint32_t>(this->GetCount(pixel));
    offsets[pixel + 1] = offset;
  }
  return offsets;
}

void RaySegments::Sort(const std::vector<std::uint32_t>& records, int most)
{
  const size_t size = static_cast<size_t>(this->Format.GetNumberOfValues());
  const size_t words = size + 3;
  for (size_t at = 0; at < records.size(); at += words)
  {
    std::uint8_t& count = this->Counts[records[at]];
    count = count < most ? static_cast<std::uint8_t>(count + 1) : (count | Lost);
  }
  const std::vector<std::uint32_t> offsets = this->FindOffsets();
  this->Begins.resize(offsets.back());
  this->Ends.resize(offsets.back());
  this->Values.resize(size * offsets.back());
  std::vector<std::uint8_t> taken(this->Counts.size(), 0);
  for (size_t at = 0; at < records.size(); at += words)
  {
    const size_t pixel = records[at];
    if (taken[pixel] < this->GetCount(pixel))
    {
      const size_t segment = offsets[pixel] + taken[pixel]++;
      std::memcpy(&this->Begins[segment], &records[at + 1], sizeof(float));
      std::memcpy(&this->Ends[segment], &records[at + 2], sizeof(float));
      std::memcpy(&this->Values[size * segment], &records[at + 3], size * sizeof(float));
    }
  }
}

std::vector<std::uint8_t> RaySegments::Pack() const
{
  const std::array<int, 4> box = FindRectangle(*this);
  const auto number = [](auto value) { return static_cast<std::uint32_t>(value); };
  const MessageHeader header = { number(this->Width), number(this->Height), number(box[0]),
    number(box[1]), number(box[2] - box[0]), number(box[3] - box[1]), number(this->Format.Blending),
    number(this->Format.NumberOfComponents), number(this->Format.AreIndependent),
    number(this->Format.HasSteepness) };
  std::vector<std::uint8_t> bytes(sizeof(header) +
    static_cast<size_t>(header.Columns) * header.Rows +
    this->GetNumberOfSegments() * GetSegmentBytes(this->Format));
  std::uint8_t* to = bytes.data();
  Put(header, to);
  for (int row = box[1]; row < box[3]; ++row)
  {
    const auto first = this->Counts.begin() + static_cast<std::ptrdiff_t>(row) * this->Width;
    to = std::copy(first + box[0], first + box[2], to);
  }
  const size_t count = this->GetNumberOfSegments();
  if (this->Format.IsOrdered())
  {
    for (size_t i = 0; i < count; ++i)
    {
      Put(this->Begins[i], to);
      SegmentColor::Put(&this->Values[4 * i], to);
    }
  }
  else if (this->Format.Blending == BlendMode::Additive)
  {
    for (size_t i = 0; i < count; ++i)
    {
      SumColor::Put(&this->Values[4 * i], to);
    }
  }
  else if (count > 0)
  {
    std::memcpy(to, this->Values.data(), this->Values.size() * sizeof(float));
  }
  return bytes;
}

bool RaySegments::Unpack(const std::vector<std::uint8_t>& message)
{
  this->Reset(0, 0, {});
  if (message.size() < sizeof(MessageHeader))
  {
    return false;
  }
  const std::uint8_t* from = message.data();
  const auto header = Take<MessageHeader>(from);
  const size_t pixels = static_cast<size_t>(header.Columns) * header.Rows;
  if (!IsValid(header) || message.size() - sizeof(header) < pixels)
  {
    return false;
  }
  RaySegments read;
  read.Reset(static_cast<int>(header.Width), static_cast<int>(header.Height),
    { static_cast<BlendMode>(header.Blending), header.AreIndependent != 0,
      static_cast<int>(header.NumberOfComponents), header.HasSteepness != 0 });
  for (std::uint32_t row = header.FirstRow; row < header.FirstRow + header.Rows; ++row)
  {
    std::copy_n(from, header.Columns,
      read.Counts.begin() + static_cast<std::ptrdiff_t>(row) * read.Width + header.FirstColumn);
    from += header.Columns;
  }
  size_t count = 0;
  for (std::uint8_t each : read.Counts)
  {
    count += each & ~Lost;
  }
  const size_t rest = message.size() - sizeof(header) - pixels;
  if (rest != count * GetSegmentBytes(read.Format))
  {
    return false;
  }
  read.Begins.resize(count);
  read.Values.resize(count * static_cast<size_t>(read.Format.GetNumberOfValues()));
  if (read.Format.IsOrdered())
  {
    for (size_t i = 0; i < count; ++i)
    {
      read.Begins[i] = Take<float>(from);
      SegmentColor::Take(from, &read.Values[4 * i]);
    }
  }
  else if (read.Format.Blending == BlendMode::Additive)
  {
    for (size_t i = 0; i < count; ++i)
    {
      SumColor::Take(from, &read.Values[4 * i]);
    }
  }
  else if (count > 0)
  {
    std::memcpy(read.Values.data(), from, read.Values.size() * sizeof(float));
  }
  read.Ends = read.Begins;
  *this = std::move(read);
  return true;
}
}
