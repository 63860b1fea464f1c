// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/TriangleBudget.h"

#include "Evaluation/FaceTags.h"
#include "Patterns/PatternFamily.h"
#include "Patterns/RefinementPattern.h"
#include "Patterns/TriangleCounts.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace relevo
{
namespace
{
// Calls `work` in parallel for each face that is not hidden, and sums the results. `sums` must have
// its final size.
template <typename Sums, typename Work>
void SumOverFaces(const TriangleBudget::Part& part, Sums& sums, const Work& work)
{
  vtkSMPThreadLocal<Sums> locals;
  vtkSMPTools::For(0, static_cast<vtkIdType>(part.Mesh->Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Sums& local = locals.Local();
      local.resize(sums.size());
      for (vtkIdType f = begin; f < end; ++f)
      {
        if (!part.Hidden || !part.Hidden[f])
        {
          work(f, local);
        }
      }
    });
  for (const Sums& local : locals)
  {
    std::transform(local.begin(), local.end(), sums.begin(), sums.begin(), std::plus<>());
  }
}

// The numbers are integers that are exact in doubles.
void AddPieces(std::vector<std::int64_t>& numbers, const PieceReduction& pieces)
{
  std::vector<double> sums(numbers.begin(), numbers.end());
  pieces.Add(sums);
  std::transform(sums.begin(), sums.end(), numbers.begin(),
    [](double sum) { return static_cast<std::int64_t>(sum); });
}

// The step of an edge with any tag.
int GetStep(const PatternFamily& family, float tag, int maximumLevel)
{
  const float clamped = clampTag(tag, 0.0f, maximumLevel);
  return family.AreWholeNumbers() ? SegmentSteps::GetWholeNumberStep(clamped) : levelOfTag(clamped);
}

// Tracks the pattern of one face while the offset rises from that of bin 0.
class RisingFace
{
public:
  RisingFace(const TriangleCounts& counts, const float tags[3], const int steps[3])
    : MinimumTags(counts.GetMinimumTags().data())
    , Triangles(counts.GetTriangles().data())
    , Strides{ counts.GetNumberOfSteps() * counts.GetNumberOfSteps(), counts.GetNumberOfSteps(), 1 }
  {
    for (int e = 0; e < 3; ++e)
    {
      this->Tags[e] = tags[e];
      this->Steps[e] = steps[e];
      this->Pattern += steps[e] * this->Strides[e];
      this->SetNext(e);
    }
  }

  int GetNumberOfTriangles() const { return this->Triangles[this->Pattern]; }

  // The change in offset to the next step, which Rise() performs.
  float GetNext() const { return std::min({ this->Next[0], this->Next[1], this->Next[2] }); }
  void Rise()
  {
    const int e = static_cast<int>(std::min_element(this->Next, this->Next + 3) - this->Next);
    ++this->Steps[e];
    this->Pattern += this->Strides[e];
    this->SetNext(e);
  }

private:
  void SetNext(int e) { this->Next[e] = this->MinimumTags[this->Steps[e] + 1] - this->Tags[e]; }

  const float* MinimumTags;
  const int* Triangles;
  int Strides[3];
  float Tags[3];
  int Steps[3];
  float Next[3];
  int Pattern = 0;
};
}

TriangleBudget::TriangleBudget() = default;
TriangleBudget::~TriangleBudget() = default;

// These offsets lie between multiples of 1 / Resolution, because tags are often such multiples.
double TriangleBudget::GetOffset(int number)
{
  return (number + 0.5) / Resolution;
}

int TriangleBudget::GetNumber(double offset)
{
  return static_cast<int>(std::floor(offset * Resolution));
}

void TriangleBudget::UpdateCounts(const std::vector<Part>& parts, int maximumLevel)
{
  decltype(this->Counts) last;
  last.swap(this->Counts);
  for (const Part& part : parts)
  {
    auto& counts = this->Counts[part.Family->GetMTime()];
    if (!counts && this->MaximumLevel == maximumLevel)
    {
      counts = std::move(last[part.Family->GetMTime()]);
    }
    if (!counts)
    {
      counts = std::make_unique<TriangleCounts>(*part.Family, maximumLevel);
    }
  }
  this->MaximumLevel = maximumLevel;
}

const TriangleCounts& TriangleBudget::GetCounts(const Part& part) const
{
  return *this->Counts.at(part.Family->GetMTime());
}

void TriangleBudget::Count(const std::vector<Part>& parts, Interval& interval) const
{
  const float first = static_cast<float>(GetOffset(interval.First));
  const float width = static_cast<float>(interval.Width);
  interval.Totals.assign(static_cast<size_t>(interval.Width) + 1, 0);
  for (const Part& part : parts)
  {
    const TriangleCounts& triangles = this->GetCounts(part);
    WithFaceTags(*part.Tags, this->MaximumLevel,
      [&](const auto& getTags)
      {
        SumOverFaces(part, interval.Totals,
          [&](vtkIdType f, Bins& bins)
          {
            float tags[3];
            getTags(f, part.Mesh->Faces[f], tags);
            int steps[3];
            for (int e = 0; e < 3; ++e)
            {
              tags[e] += first;
              steps[e] = GetStep(*part.Family, tags[e], this->MaximumLevel);
            }
            RisingFace face(triangles, tags, steps);
            int count = face.GetNumberOfTriangles();
            bins[0] += count;
            for (float next = std::ceil(face.GetNext() * Resolution); next <= width;
                 next = std::ceil(face.GetNext() * Resolution))
            {
              face.Rise();
              bins[std::max(1, static_cast<int>(next))] += face.GetNumberOfTriangles() - count;
              count = face.GetNumberOfTriangles();
            }
          });
      });
  }
}

int TriangleBudget::FindNumber(const std::vector<Part>& parts, double target, int lowest,
  int highest, int guess, const PieceReduction& pieces)
{
  Bins extremes(2, 0);
  for (const Part& part : parts)
  {
    auto faces = static_cast<std::int64_t>(part.Mesh->Faces.size());
    if (part.Hidden)
    {
      faces = std::count(part.Hidden, part.Hidden + faces, static_cast<unsigned char>(0));
    }
    extremes[0] += faces;
    extremes[1] += faces * this->GetCounts(part).GetTriangles().back();
  }
  AddPieces(extremes, pieces);
  const std::int64_t least = extremes[0];
  const std::int64_t most = extremes[1];
  if (least == most)
  {
    return std::max(lowest, std::min(0, highest));
  }
  // Whether the result is at or above an offset with this number of triangles.
  const auto isBelow = [&](std::int64_t triangles)
  {
    const auto count = static_cast<double>(triangles);
    return triangles < most && (count <= target || triangles == least);
  };

  constexpr int narrow = Resolution / 8;
  constexpr int wide = Resolution;
  Interval interval;
  interval.Width = narrow;
  interval.First = std::max(lowest, std::min(guess - narrow / 2, highest - narrow));
  bool rising = false;
  for (;;)
  {
    interval.Width = std::min(interval.Width, highest - interval.First);
    this->Count(parts, interval);
    AddPieces(interval.Totals, pieces);
    std::partial_sum(interval.Totals.begin(), interval.Totals.end(), interval.Totals.begin());
    const int width = std::min(2 * interval.Width, wide);
    if (!isBelow(interval.Totals.front()) && interval.First > lowest && !rising)
    {
      const int last = interval.First;
      interval.First = std::max(lowest, last - width);
      interval.Width = last - interval.First;
    }
    else if (isBelow(interval.Totals.back()) && interval.First + interval.Width < highest)
    {
      rising = true; // do not reverse if rounding changes the number by one face
      interval.First += interval.Width;
      interval.Width = width;
    }
    else
    {
      break;
    }
  }

  const Bins& totals = interval.Totals;
  const auto above = std::partition_point(totals.begin(), totals.end(), isBelow);
  const int number = interval.First + static_cast<int>(above - totals.begin());
  if (above == totals.end() || above == totals.begin())
  {
    return std::max(lowest, number - 1);
  }
  const auto more = static_cast<double>(*above);
  const auto fewer = static_cast<double>(above[-1]);
  const bool nearer = more <= (1.0 + Tolerance) * target && more - target < target - fewer;
  return more <= target || nearer ? number : number - 1;
}

double TriangleBudget::FindOffset(const std::vector<Part>& parts, int maximumLevel,
  vtkIdType target, double lowest, double highest, double guess, const PieceReduction& pieces)
{
  this->UpdateCounts(parts, maximumLevel);
  const int lowestNumber = GetNumber(lowest);
  const int highestNumber = std::max(lowestNumber, GetNumber(highest));
  std::vector<double> estimates(1, 0.0);
  for (const Part& part : parts)
  {
    estimates[0] = this->GetCounts(part).AreEstimates() ? 1.0 : estimates[0];
  }
  pieces.TakeLargest(estimates);

  // If counts are estimates, correct the target by their error and repeat.
  constexpr int tries = 4;
  constexpr double goodEnough = 0.02;
  const auto wanted = static_cast<double>(target);
  double aim = wanted;
  int best = GetNumber(guess);
  double bestError = 0.0;
  for (int i = 0; i < tries; ++i)
  {
    const int number = this->FindNumber(parts, aim, lowestNumber, highestNumber, best, pieces);
    if (estimates[0] == 0.0)
    {
      best = number;
      break;
    }
    Bins counts(1, CountTriangles(parts, maximumLevel, GetOffset(number)));
    AddPieces(counts, pieces);
    const auto count = static_cast<double>(counts[0]);
    const double error = std::abs(std::log(count / wanted));
    if (i == 0 || error < bestError)
    {
      best = number;
      bestError = error;
    }
    if (error < goodEnough || !(count > 0.0))
    {
      break;
    }
    aim *= wanted / count;
  }
  return std::max(lowest, std::min(GetOffset(best), highest));
}

vtkIdType TriangleBudget::CountTriangles(
  const std::vector<Part>& parts, int maximumLevel, double offset)
{
  vtkIdType triangles = 0;
  for (const Part& part : parts)
  {
    const PatternFamily& family = *part.Family;
    std::vector<vtkIdType> faces(static_cast<size_t>(family.GetNumberOfKeys()));
    WithFaceTags(*part.Tags, maximumLevel,
      [&](const auto& getTags)
      {
        SumOverFaces(part, faces,
          [&](vtkIdType f, std::vector<vtkIdType>& counts)
          {
            float tags[3];
            getTags(f, part.Mesh->Faces[f], tags);
            int steps[3];
            for (int e = 0; e < 3; ++e)
            {
              steps[e] = GetStep(family, tags[e] + static_cast<float>(offset), maximumLevel);
            }
            ++counts[family.GetEntry(0, steps[0], steps[1], steps[2]) >> 3];
          });
      });
    for (int key = 0; key < family.GetNumberOfKeys(); ++key)
    {
      if (faces[key] > 0)
      {
        triangles += faces[key] * family.GetPattern(key)->GetNumberOfTriangles();
      }
    }
  }
  return triangles;
}
}
