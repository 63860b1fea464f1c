// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/SegmentSearch.h"

#include "Metrics/PatchDeviations.h"
#include "Metrics/PatternExtents.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double MaximumSegments = 1e9; // limit beyond which levels make no difference

// Returns the number of segments for a deviation that decreases with its square.
double GetSegments(double deviation, double limit)
{
  const double segments = deviation > 0.0 ? std::sqrt(deviation / limit) : 1.0;
  return segments < MaximumSegments ? std::max(std::ceil(segments), 1.0) : MaximumSegments;
}

class Search
{
public:
  Search(const PatchDeviations& deviations, const PatternExtents& patterns,
    const std::vector<double>& limits, int maximumLevel)
    : Deviations(deviations)
    , Patterns(patterns)
    , Limits(limits)
    , Steps(patterns.GetSegmentSteps())
    , HighestStep(this->Steps.FindStep(1 << std::min(maximumLevel, 16)))
  {
  }

  void Run()
  {
    this->Begin();
    std::vector<int> faces(this->Deviations.GetFaces().size());
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      faces[f] = static_cast<int>(f);
    }
    while (!faces.empty())
    {
      this->Measure(faces);
      faces = this->Raise(faces);
    }
  }

  // Beyond the largest pattern, levels continue as if the error decreased quadratically. With
  // geomorphing, half a level is added: vertices of the last step are then in their final position,
  // and those of the next have not started to move.
  float GetLevel(int edge) const
  {
    const int step = this->EdgeSteps[edge];
    double excess = 1.0;
    if (step == this->HighestStep)
    {
      this->Deviations.ForEachFace(
        edge, [&](int f) { excess = std::max(excess, this->Excesses[f]); });
    }
    const double segments =
      std::min(this->Steps.GetSegments(step) * std::sqrt(excess), MaximumSegments);
    const auto level = static_cast<float>(std::log2(segments));
    return this->Patterns.AreMorphing() ? std::nextafter(level + 0.5f, 0.0f) : level;
  }

private:
  void Begin()
  {
    const std::vector<double>& chords = this->Deviations.GetChords();
    this->EdgeSteps.resize(chords.size());
    this->Excesses.assign(this->Limits.size(), 1.0);
    vtkSMPTools::For(0, static_cast<vtkIdType>(chords.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int edge = static_cast<int>(begin); edge < end; ++edge)
        {
          double segments = 1.0;
          this->Deviations.ForEachFace(edge,
            [&](int f)
            { segments = std::max(segments, GetSegments(chords[edge], this->Limits[f])); });
          this->EdgeSteps[edge] =
            std::min(this->Steps.FindStep(static_cast<int>(segments)), this->HighestStep);
        }
      });
  }

  PatternExtents::Steps GetSteps(int face) const
  {
    const std::array<int, 3>& edges = this->Deviations.GetFaces()[face].Edges;
    return { { this->EdgeSteps[edges[0]], this->EdgeSteps[edges[1]], this->EdgeSteps[edges[2]] } };
  }

  // Computes the factors by which faces exceed their limits.
  void Measure(const std::vector<int>& faces)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const int f = faces[i];
          const double deviation =
            this->Patterns.Measure(this->GetSteps(f), this->Deviations.GetFaces()[f].Form) / 8.0;
          this->Excesses[f] =
            deviation <= this->Limits[f] ? 1.0 : std::min(deviation / this->Limits[f], 1e30);
        }
      });
  }

  // Raises the edges with the smallest step of faces that deviate too much. Returns the faces to
  // measure again.
  std::vector<int> Raise(const std::vector<int>& faces)
  {
    std::vector<int> raised;
    for (int f : faces)
    {
      const PatternExtents::Steps steps = this->GetSteps(f);
      const int least = *std::min_element(steps.begin(), steps.end());
      if (this->Excesses[f] <= 1.0 || least == this->HighestStep)
      {
        continue;
      }
      for (int edge : this->Deviations.GetFaces()[f].Edges)
      {
        if (this->EdgeSteps[edge] == least)
        {
          raised.push_back(edge);
        }
      }
    }
    std::sort(raised.begin(), raised.end());
    raised.erase(std::unique(raised.begin(), raised.end()), raised.end());
    std::vector<int> next;
    for (int edge : raised)
    {
      ++this->EdgeSteps[edge];
      this->Deviations.ForEachFace(edge, [&](int f) { next.push_back(f); });
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
  }

  const PatchDeviations& Deviations;
  const PatternExtents& Patterns;
  const std::vector<double>& Limits;
  const SegmentSteps& Steps;
  const int HighestStep;
  std::vector<int> EdgeSteps;
  std::vector<double> Excesses; // one per face, at least 1
};
}

float FindCurveLevel(const PatternExtents& patterns, double chord, double limit)
{
  const double segments = GetSegments(chord, limit);
  const SegmentSteps& steps = patterns.GetSegmentSteps();
  const double most = steps.GetSegments(steps.GetNumberOfSteps() - 1);
  return static_cast<float>(std::log2(
    segments > most ? segments : steps.GetSegments(steps.FindStep(static_cast<int>(segments)))));
}

void FindEdgeLevels(const PatchDeviations& deviations, const PatternExtents& patterns,
  const std::vector<double>& limits, int maximumLevel, float* levels)
{
  Search search(deviations, patterns, limits, maximumLevel);
  search.Run();
  const auto numberOfEdges = static_cast<vtkIdType>(deviations.GetChords().size());
  vtkSMPTools::For(0, numberOfEdges,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int edge = static_cast<int>(begin); edge < end; ++edge)
      {
        levels[edge] = std::min(search.GetLevel(edge), static_cast<float>(maximumLevel));
      }
    });
}
}
