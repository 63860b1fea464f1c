// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Segments/SegmentMerger.h"

#include "Mesh/MeshExtent.h"
#include "Segments/RaySegments.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace relevo
{
namespace
{
struct PixelSegment
{
  float Begin;
  float End;
  const float* Values;
};

struct PieceRows
{
  explicit PieceRows(const RaySegments& segments)
    : Segments(&segments)
    , Offsets({ 0 })
  {
    for (auto row = segments.Counts.begin(); row != segments.Counts.end(); row += segments.Width)
    {
      Offsets.push_back(std::accumulate(row, row + segments.Width, Offsets.back(),
        [](size_t sum, std::uint8_t count)
        { return sum + static_cast<size_t>(count & ~RaySegments::Lost); }));
    }
  }

  const RaySegments* Segments;
  std::vector<size_t> Offsets; // the first segment of each row, and the number of segments
};

// Equal segments have equal values, so that the order of the pieces has no effect.
bool IsInFront(const PixelSegment& a, const PixelSegment& b, int size)
{
  if (a.Begin != b.Begin || a.End != b.End)
  {
    return std::tie(a.Begin, a.End) < std::tie(b.Begin, b.End);
  }
  return std::lexicographical_compare(a.Values, a.Values + size, b.Values, b.Values + size);
}

// The segments are sorted.
void Composite(const std::vector<PixelSegment>& segments, float* to)
{
  for (const PixelSegment& segment : segments)
  {
    const float clear = 1.0f - to[3];
    for (int c = 0; c < 4; ++c)
    {
      to[c] += clear * segment.Values[c];
    }
  }
}

void Add(const std::vector<PixelSegment>& segments, int size, float* to)
{
  for (const PixelSegment& segment : segments)
  {
    for (int i = 0; i < size; ++i)
    {
      to[i] += segment.Values[i];
    }
  }
}

// The gradient magnitudes follow the scalars.
void FindExtremes(const std::vector<PixelSegment>& segments, const SegmentFormat& format, float* to)
{
  const float sign = format.Blending == BlendMode::Maximum ? 1.0f : -1.0f;
  const int width = format.GetWidth();
  const int last = format.NumberOfComponents - 1;
  for (int c = 0; c < width; ++c)
  {
    const int deciding = format.AreIndependent ? std::min(c, last) : last;
    const auto found = std::max_element(segments.begin(), segments.end(),
      [=](const PixelSegment& a, const PixelSegment& b)
      { return sign * a.Values[deciding] < sign * b.Values[deciding]; });
    for (int i = c; i < format.GetNumberOfValues(); i += width)
    {
      to[i] = found->Values[i];
    }
  }
}

// Merges the segments of one row of pixels after the other.
class RowMerger
{
public:
  RowMerger(const std::vector<PieceRows>& pieces, MergedSegments& merged)
    : Pieces(pieces)
    , Next(pieces.size())
    , Format(merged.Format)
    , Size(Format.GetNumberOfValues())
    , Merged(merged.Values)
  {
  }

  void Merge(size_t row)
  {
    bool isEmpty = true;
    for (size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      this->Next[piece] = this->Pieces[piece].Offsets[row];
      isEmpty = isEmpty && this->Pieces[piece].Offsets[row + 1] == this->Next[piece];
    }
    const size_t width = static_cast<size_t>(this->Pieces.front().Segments->Width);
    for (size_t pixel = row * width; pixel < (row + 1) * width && !isEmpty; ++pixel)
    {
      this->Collect(pixel);
      if (!this->Segments.empty())
      {
        this->MergePixel(&this->Merged[static_cast<size_t>(this->Size) * pixel]);
      }
    }
  }

private:
  // Pixels come in their order.
  void Collect(size_t pixel)
  {
    this->Segments.clear();
    for (size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      const RaySegments& from = *this->Pieces[piece].Segments;
      size_t& next = this->Next[piece];
      for (const size_t end = next + static_cast<size_t>(from.GetCount(pixel)); next < end; ++next)
      {
        this->Segments.push_back({ from.Begins[next], from.Ends[next],
          &from.Values[static_cast<size_t>(this->Size) * next] });
      }
    }
  }

  void MergePixel(float* to)
  {
    std::sort(this->Segments.begin(), this->Segments.end(),
      [this](const PixelSegment& a, const PixelSegment& b) { return IsInFront(a, b, this->Size); });
    if (this->Format.IsOrdered())
    {
      Composite(this->Segments, to);
    }
    else if (this->Format.IsExtreme())
    {
      FindExtremes(this->Segments, this->Format, to);
    }
    else
    {
      Add(this->Segments, this->Size, to);
    }
  }

  const std::vector<PieceRows>& Pieces;
  std::vector<size_t> Next; // segment of each piece
  const SegmentFormat Format;
  const int Size;
  std::vector<float>& Merged;
  std::vector<PixelSegment> Segments; // of a pixel
};

// Map the scalars of a ray to a colour.
class ScalarMapper
{
public:
  ScalarMapper(
    const SegmentFormat& format, const TransferFunctions& functions, const MeshExtent& whole)
    : Format(format)
    , Functions(functions)
    , Whole(whole)
  {
  }

  dvec4 Map(const float* values) const
  {
    const int width = this->Format.GetWidth();
    const bool isAverage = this->Format.Blending == BlendMode::Average;
    if (isAverage ? !(values[width] > 0.0f) : std::isnan(values[0]))
    {
      return dvec4(0.0);
    }
    const double scale = isAverage ? 1.0 / static_cast<double>(values[width]) : 1.0;
    const float* steepnesses = values + width + (isAverage ? 1 : 0);
    Scalars scalars = {};
    Scalars steepness = {};
    for (int c = 0; c < this->Format.NumberOfComponents; ++c)
    {
      const double size = this->Whole.GetScalarSize(c);
      scalars[c] = this->Whole.ScalarLow[c] + size * scale * static_cast<double>(values[c]);
      steepness[c] = this->Format.HasSteepness
        ? size / this->Whole.GetRadius() * scale * static_cast<double>(steepnesses[c])
        : 0.0;
    }
    const dvec4 color = this->Functions.Map(scalars, steepness);
    return dvec4(color.w * dvec3(color), color.w);
  }

private:
  const SegmentFormat& Format;
  const TransferFunctions& Functions;
  const MeshExtent& Whole;
};
}

MergedSegments MergeSegments(const std::vector<const RaySegments*>& pieces)
{
  MergedSegments merged;
  std::vector<PieceRows> filled;
  for (const RaySegments* piece : pieces)
  {
    if (piece->GetNumberOfSegments() > 0)
    {
      filled.emplace_back(*piece);
    }
  }
  const size_t pixels = pieces.empty() ? 0 : pieces.front()->Counts.size();
  merged.Format = filled.empty() ? SegmentFormat() : filled.front().Segments->Format;
  merged.Values.assign(pixels * static_cast<size_t>(merged.Format.GetNumberOfValues()),
    merged.Format.IsExtreme() ? std::numeric_limits<float>::quiet_NaN() : 0.0f);
  if (filled.empty())
  {
    return merged;
  }
  vtkSMPTools::For(0, pieces.front()->Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      RowMerger merger(filled, merged);
      for (vtkIdType row = begin; row < end; ++row)
      {
        merger.Merge(static_cast<size_t>(row));
      }
    });
  return merged;
}

std::vector<float> MapSegments(
  MergedSegments merged, const TransferFunctions& functions, const MeshExtent& whole)
{
  if (merged.Format.IsOrdered())
  {
    return std::move(merged.Values);
  }
  const ScalarMapper mapper(merged.Format, functions, whole);
  const size_t size = static_cast<size_t>(merged.Format.GetNumberOfValues());
  const size_t pixels = merged.Values.size() / size;
  std::vector<float> colors(4 * pixels, 0.0f);
  vtkSMPTools::For(0, static_cast<vtkIdType>(pixels),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (size_t pixel = static_cast<size_t>(begin); pixel < static_cast<size_t>(end); ++pixel)
      {
        const float* values = &merged.Values[size * pixel];
        const dvec4 color = merged.Format.Blending == BlendMode::Additive
          ? min(dvec4(values[0], values[1], values[2], values[3]), dvec4(1.0))
          : mapper.Map(values);
        for (size_t c = 0; c < 4; ++c)
        {
          colors[4 * pixel + c] = static_cast<float>(color[static_cast<int>(c)]);
        }
      }
    });
  return colors;
}

void MarkLostPixels(const std::vector<const RaySegments*>& pieces, std::vector<bool>& lost)
{
  for (const RaySegments* piece : pieces)
  {
    if (!piece->HasLost())
    {
      continue;
    }
    lost.resize(piece->Counts.size());
    for (size_t pixel = 0; pixel < lost.size(); ++pixel)
    {
      lost[pixel] = lost[pixel] || piece->HasLost(pixel);
    }
  }
}
}
