// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Segments/RaySegments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace relevo
{
namespace
{
constexpr int ExponentBias = 128;
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

bool IsColor(const SegmentFormat& format)
{
  return format.IsOrdered() || format.Blending == BlendMode::Additive;
}

// Return the bits of a colour's component. The exponent has 8 bits.
int GetMantissaBits(const SegmentFormat& format)
{
  return format.IsOrdered() ? 10 : 14;
}

size_t GetColorBytes(const SegmentFormat& format)
{
  return 1 + static_cast<size_t>(GetMantissaBits(format)) / 2;
}

size_t GetSegmentBytes(const SegmentFormat& format)
{
  return (format.IsOrdered() ? sizeof(float) : 0) +
    (IsColor(format) ? GetColorBytes(format)
                     : sizeof(float) * static_cast<size_t>(format.GetNumberOfValues()));
}

template <typename T>
void Append(const T& value, std::vector<std::uint8_t>& bytes)
{
  const auto* begin = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), begin, begin + sizeof(T));
}

template <typename T>
T Take(const std::uint8_t*& from)
{
  T value;
  std::memcpy(&value, from, sizeof(T));
  from += sizeof(T);
  return value;
}

// Colours are not negative.
void AppendColor(
  const float color[4], const SegmentFormat& format, std::vector<std::uint8_t>& bytes)
{
  const int bits = GetMantissaBits(format);
  const float largest =
    std::clamp(std::max({ color[0], color[1], color[2], color[3] }), 1e-37f, 1e37f);
  int exponent = 0;
  std::frexp(largest, &exponent);
  const float scale = std::ldexp(static_cast<float>((1 << bits) - 1), -exponent);
  std::uint64_t word = static_cast<std::uint64_t>(exponent + ExponentBias);
  for (int c = 0; c < 4; ++c)
  {
    const auto digits =
      static_cast<std::uint64_t>(std::lround(std::clamp(color[c], 0.0f, largest) * scale));
    word |= digits << (8 + bits * c);
  }
  for (size_t i = 0; i < GetColorBytes(format); ++i)
  {
    bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
  }
}

void TakeColor(const std::uint8_t*& from, const SegmentFormat& format, std::vector<float>& values)
{
  const int bits = GetMantissaBits(format);
  const std::uint64_t largest = (std::uint64_t(1) << bits) - 1;
  std::uint64_t word = 0;
  for (size_t i = 0; i < GetColorBytes(format); ++i)
  {
    word |= static_cast<std::uint64_t>(*from++) << (8 * i);
  }
  const float scale =
    std::ldexp(1.0f / static_cast<float>(largest), static_cast<int>(word & 255) - ExponentBias);
  for (int c = 0; c < 4; ++c)
  {
    values.push_back(scale * static_cast<float>((word >> (8 + bits * c)) & largest));
  }
}

// Return the first column and row with segments, and the first behind them.
std::array<int, 4> FindRectangle(const RaySegments& segments)
{
  std::array<int, 4> box = { { segments.Width, segments.Height, 0, 0 } };
  for (int row = 0; row < segments.Height; ++row)
  {
    for (int column = 0; column < segments.Width; ++column)
    {
      if (segments.Counts[static_cast<size_t>(row) * segments.Width + column] > 0)
      {
        box = { { std::min(box[0], column), std::min(box[1], row), std::max(box[2], column + 1),
          std::max(box[3], row + 1) } };
      }
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

std::vector<size_t> RaySegments::FindOffsets() const
{
  std::vector<size_t> offsets = { 0 };
  offsets.reserve(this->Counts.size() + 1);
  for (size_t pixel = 0; pixel < this->Counts.size(); ++pixel)
  {
    offsets.push_back(offsets.back() + static_cast<size_t>(this->GetCount(pixel)));
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
  const std::vector<size_t> offsets = this->FindOffsets();
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
  std::vector<std::uint8_t> bytes;
  bytes.reserve(sizeof(header) + static_cast<size_t>(header.Columns) * header.Rows +
    this->GetNumberOfSegments() * GetSegmentBytes(this->Format));
  Append(header, bytes);
  for (int row = box[1]; row < box[3]; ++row)
  {
    const auto first = this->Counts.begin() + static_cast<std::ptrdiff_t>(row) * this->Width;
    bytes.insert(bytes.end(), first + box[0], first + box[2]);
  }
  const size_t size = static_cast<size_t>(this->Format.GetNumberOfValues());
  for (size_t i = 0; i < this->GetNumberOfSegments(); ++i)
  {
    if (this->Format.IsOrdered())
    {
      Append(this->Begins[i], bytes);
    }
    if (IsColor(this->Format))
    {
      AppendColor(&this->Values[size * i], this->Format, bytes);
      continue;
    }
    for (size_t j = 0; j < size; ++j)
    {
      Append(this->Values[size * i + j], bytes);
    }
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
  const size_t count = read.FindOffsets().back();
  const size_t rest = message.size() - sizeof(header) - pixels;
  if (rest != count * GetSegmentBytes(read.Format))
  {
    return false;
  }
  read.Begins.reserve(count);
  for (size_t i = 0; i < count; ++i)
  {
    read.Begins.push_back(read.Format.IsOrdered() ? Take<float>(from) : 0.0f);
    if (IsColor(read.Format))
    {
      TakeColor(from, read.Format, read.Values);
      continue;
    }
    for (int j = 0; j < read.Format.GetNumberOfValues(); ++j)
    {
      read.Values.push_back(Take<float>(from));
    }
  }
  read.Ends = read.Begins;
  *this = std::move(read);
  return true;
}
}
