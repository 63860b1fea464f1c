// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the ray segments of pieces join without gaps and overlaps, that their number is
// bounded, and that messages contain them.
#include "RelevoCheck.h"
#include "RelevoVolumePieces.h"

#include "Segments/SegmentMerger.h"

#include "vtkContourValues.h"

#include <algorithm>
#include <cmath>

namespace
{
using relevo::RaySegments;
using Interval = std::array<float, 2>;

// The intervals of all pieces at each pixel, in order. Those that join are one.
std::vector<std::vector<Interval>> JoinSegments(
  const std::vector<RaySegments>& pieces, float tolerance)
{
  std::vector<std::vector<Interval>> pixels(pieces.front().Counts.size());
  for (const RaySegments& piece : pieces)
  {
    const std::vector<std::uint32_t> offsets = piece.FindOffsets();
    for (size_t pixel = 0; pixel < pixels.size(); ++pixel)
    {
      for (size_t i = offsets[pixel]; i < offsets[pixel + 1]; ++i)
      {
        pixels[pixel].push_back({ { piece.Begins[i], piece.Ends[i] } });
      }
    }
  }
  for (std::vector<Interval>& all : pixels)
  {
    std::sort(all.begin(), all.end());
    std::vector<Interval> joined;
    for (const Interval& interval : all)
    {
      if (!joined.empty() && std::abs(interval[0] - joined.back()[1]) <= tolerance)
      {
        joined.back()[1] = interval[1];
      }
      else
      {
        joined.push_back(interval);
      }
    }
    all = joined;
  }
  return pixels;
}

bool AreSame(const std::vector<Interval>& a, const std::vector<Interval>& b, float tolerance)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [=](const Interval& x, const Interval& y)
      { return std::abs(x[0] - y[0]) <= tolerance && std::abs(x[1] - y[1]) <= tolerance; });
}

// Return the number of pixels where the joined segments differ.
size_t CountGaps(
  const std::vector<RaySegments>& pieces, const std::vector<RaySegments>& whole, float tolerance)
{
  const auto a = JoinSegments(pieces, tolerance);
  const auto b = JoinSegments(whole, tolerance);
  size_t gaps = 0;
  for (size_t pixel = 0; pixel < a.size(); ++pixel)
  {
    gaps += AreSame(a[pixel], b[pixel], tolerance) ? 0 : 1;
  }
  return gaps;
}

double AddLengths(const std::vector<RaySegments>& pieces)
{
  double sum = 0.0;
  for (const RaySegments& piece : pieces)
  {
    for (size_t i = 0; i < piece.GetNumberOfSegments(); ++i)
    {
      sum += static_cast<double>(piece.Ends[i]) - static_cast<double>(piece.Begins[i]);
    }
  }
  return sum;
}

// Nothing is opaque, so that rays do not end early, and nothing is clear.
vtkSmartPointer<vtkVolumeProperty> MakeThinProperty()
{
  return MakeVolumeProperty(0.02, 0.05);
}

// With isosurfaces, the depths of tetrahedra have the same bits in all pieces, so that no surface
// is lost or drawn twice. Other depths are rounded.
void TestJoints(
  RelevoCheck& check, vtkUnstructuredGrid* mesh, float tolerance, bool hasSurfaces = false)
{
  RelevoVolumeScene scene(mesh, MakeThinProperty(), 120, 90);
  scene.GetMapper()->SetIsoSurfaces(hasSurfaces);
  scene.GetVolume()->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 0.5);
  RelevoVolumePieces whole(scene, { mesh });
  whole.Cast();
  const double length = AddLengths(whole.GetSegments());
  CHECK_GREATER(length, 100.0);
  for (RelevoDealing dealing :
    { RelevoDealing::Random, RelevoDealing::Slabs, RelevoDealing::Blobs, RelevoDealing::Awkward })
  {
    for (int count : { 3, 7 })
    {
      CHECK_CASE(static_cast<int>(dealing));
      CHECK_CASE(count);
      RelevoVolumePieces pieces(scene, DealCells(mesh, dealing, count));
      pieces.Cast();
      CHECK_EQUAL(CountGaps(pieces.GetSegments(), whole.GetSegments(), tolerance), 0);
      CHECK_NEAR(AddLengths(pieces.GetSegments()), length, 1e-5 * length);
      // A missing piece leaves gaps.
      std::vector<RaySegments> some = pieces.GetSegments();
      some.erase(std::max_element(some.begin(), some.end(),
        [](const RaySegments& a, const RaySegments& b)
        { return a.GetNumberOfSegments() < b.GetNumberOfSegments(); }));
      CHECK_GREATER(CountGaps(some, whole.GetSegments(), tolerance), 50);
      CHECK_LESS(AddLengths(some), 0.95 * length);
    }
  }
}

// Eight layers along the rays, which alternate between two pieces.
class Layers
{
public:
  Layers()
    : Mesh(MakeTetrahedra(8, GetLinearField))
    , Scene(this->Mesh, MakeThinProperty(), 97, 97)
  {
    LookAlongEdges(this->Scene);
  }
  std::vector<RaySegments> Cast(int most, bool usesBuffers = true)
  {
    this->Scene.GetMapper()->SetMaximumSegments(most);
    const auto choose = [](const RelevoPoint& center)
    { return static_cast<int>(8.0 * center[2]) % 2; };
    RelevoVolumePieces pieces(this->Scene, DealCells(this->Mesh, choose, 2));
    pieces.GetRequest().UsesStorageBuffers = usesBuffers;
    pieces.Cast();
    return pieces.GetSegments();
  }

private:
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  RelevoVolumeScene Scene;
};

// Rays in columns and rows 24 and 72 touch the cube.
bool IsAt(size_t pixel, size_t first, size_t last)
{
  const size_t column = pixel % 97;
  const size_t row = pixel / 97;
  return column >= first && column <= last && row >= first && row <= last;
}

bool AreNearest(const RaySegments& some, const RaySegments& all)
{
  const std::vector<std::uint32_t> from = all.FindOffsets();
  const std::vector<std::uint32_t> to = some.FindOffsets();
  bool areNearest = true;
  for (size_t pixel = 0; pixel < all.Counts.size(); ++pixel)
  {
    for (size_t i = 0; i < to[pixel + 1] - to[pixel]; ++i)
    {
      areNearest = areNearest && some.Begins[to[pixel] + i] == all.Begins[from[pixel] + i] &&
        some.Values[4 * (to[pixel] + i)] == all.Values[4 * (from[pixel] + i)];
    }
  }
  return areNearest;
}

std::ptrdiff_t CountLostPixels(const std::vector<const RaySegments*>& pieces)
{
  std::vector<bool> lost;
  relevo::MarkLostPixels(pieces, lost);
  return std::count(lost.begin(), lost.end(), true);
}

void TestCounts(RelevoCheck& check)
{
  Layers layers;
  const std::vector<RaySegments> all = layers.Cast(64);
  const std::vector<RaySegments> some = layers.Cast(3);
  for (size_t piece = 0; piece < 2; ++piece)
  {
    CHECK_CASE(piece);
    std::ptrdiff_t hits = 0;
    for (size_t pixel = 0; pixel < all[piece].Counts.size(); ++pixel)
    {
      const bool isInside = IsAt(pixel, 25, 71);
      if (!isInside && IsAt(pixel, 24, 72))
      {
        continue;
      }
      CHECK_EQUAL(all[piece].GetCount(pixel), isInside ? 4 : 0);
      CHECK_EQUAL(some[piece].GetCount(pixel), isInside ? 3 : 0);
      CHECK_EQUAL(some[piece].HasLost(pixel), isInside);
      hits += isInside ? 1 : 0;
    }
    CHECK(AreNearest(some[piece], all[piece]));
    const std::ptrdiff_t lost = CountLostPixels({ &some[piece], &all[piece] });
    CHECK_GREATER_EQUAL(lost, hits);
    CHECK_LESS_EQUAL(lost, 49 * 49);
    CHECK_EQUAL(CountLostPixels({ &all[piece] }), 0);
  }
}

// Without storage buffers the segments are the same.
void TestPasses(RelevoCheck& check)
{
  Layers layers;
  for (int most : { 3, 64 })
  {
    CHECK_CASE(most);
    const std::vector<RaySegments> buffered = layers.Cast(most);
    const std::vector<RaySegments> passed = layers.Cast(most, false);
    for (size_t piece = 0; piece < 2; ++piece)
    {
      CHECK(passed[piece].Counts == buffered[piece].Counts);
      CHECK_EQUAL(passed[piece].Values.size(), buffered[piece].Values.size());
      for (size_t i = 0; i < passed[piece].GetNumberOfSegments(); ++i)
      {
        CHECK_NEAR(passed[piece].Begins[i], buffered[piece].Begins[i], 1e-6);
        CHECK_NEAR(passed[piece].Ends[i], buffered[piece].Ends[i], 1e-6);
        CHECK_NEAR(passed[piece].Values[4 * i], buffered[piece].Values[4 * i], 1e-6);
      }
    }
  }
}

void TestMessages(RelevoCheck& check)
{
  Layers layers;
  const RaySegments segments = layers.Cast(3).front();
  const std::vector<std::uint8_t> message = segments.Pack();
  const size_t rest = message.size() - 40 - 10 * segments.GetNumberOfSegments();
  CHECK_GREATER_EQUAL(rest, 47 * 47);
  CHECK_LESS_EQUAL(rest, 49 * 49);
  RaySegments received;
  CHECK(received.Unpack(message));
  CHECK_EQUAL(received.Width, 97);
  CHECK(received.Counts == segments.Counts);
  CHECK(received.Begins == segments.Begins);
  for (size_t i = 0; i < segments.Values.size(); ++i)
  {
    const auto first = segments.Values.begin() + static_cast<std::ptrdiff_t>(i / 4 * 4);
    const float largest = *std::max_element(first, first + 4);
    CHECK_NEAR(received.Values[i], segments.Values[i], largest / 2047.0f);
  }
  for (size_t size : { size_t(0), size_t(39), size_t(100), message.size() - 1 })
  {
    CHECK_CASE(size);
    std::vector<std::uint8_t> damaged(
      message.begin(), message.begin() + static_cast<std::ptrdiff_t>(size));
    CHECK(!received.Unpack(damaged));
    CHECK_EQUAL(received.GetNumberOfSegments(), 0);
  }
  std::vector<std::uint8_t> damaged = message;
  damaged[8] = 200; // the first column
  CHECK(!received.Unpack(damaged));
  RaySegments empty;
  empty.Reset(5, 4, segments.Format);
  CHECK_EQUAL(empty.Pack().size(), 40);
  CHECK(received.Unpack(empty.Pack()));
  CHECK_EQUAL(received.Counts.size(), 20);
}

void TestOrder(RelevoCheck& check)
{
  const auto mesh = MakeBall(300);
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), 100, 75);
  for (int mode = 0; mode < 6; ++mode)
  {
    CHECK_CASE(mode);
    scene.GetMapper()->SetBlendMode(mode);
    RelevoVolumePieces pieces(scene, DealCells(mesh, RelevoDealing::Random, 4));
    pieces.Cast();
    std::vector<const RaySegments*> all;
    for (const RaySegments& segments : pieces.GetSegments())
    {
      all.push_back(&segments);
    }
    const std::vector<float> merged = relevo::MergeSegments(all).Values;
    std::reverse(all.begin(), all.end());
    const std::vector<float> reversed = relevo::MergeSegments(all).Values;
    CHECK(std::equal(merged.begin(), merged.end(), reversed.begin(), reversed.end(),
      [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
  }
  CHECK(relevo::MergeSegments({}).Values.empty());
}

void TestSetting(RelevoCheck& check)
{
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> mapper;
  RelevoErrors errors(mapper);
  CHECK_EQUAL(mapper->GetMaximumSegments(), 64);
  for (int number : { 0, 128 })
  {
    mapper->SetMaximumSegments(number);
    CHECK(errors.Said("MaximumSegments"));
    CHECK_EQUAL(mapper->GetMaximumSegments(), 64);
  }
  mapper->SetMaximumSegments(127);
  CHECK_EQUAL(mapper->GetMaximumSegments(), 127);
  CHECK(errors.None());
}
}

int TestGPUUnstructuredGridVolumeMapperSegments(int, char*[])
{
  RelevoCheck check;
  TestSetting(check);
  TestJoints(check, MakeBall(800), 0.0f, true);
  TestJoints(check, MakeBall(800), 1e-6f);
  TestJoints(check, MakeMixedCells(6, GetWaves), 1e-5f);
  TestCounts(check);
  TestPasses(check);
  TestMessages(check);
  TestOrder(check);
  return check.GetResult();
}
