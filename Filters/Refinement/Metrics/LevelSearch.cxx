// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/LevelSearch.h"

#include "Levels/EdgeLevels.h"
#include "Mathematics/CornerOrder.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/DisplacedFaces.h"
#include "Patterns/PatternFamily.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double MaximumExcess = 1e30;
}

void LevelSearch::UseEdges(const DisplacedFaces& faces, const SurfaceEdges& edges)
{
  this->ArePoints = false;
  const std::vector<int> faceEdges = faces.FindEdges(edges);
  this->FaceVariables.resize(static_cast<std::size_t>(faces.GetNumberOfFaces()));
  for (std::size_t f = 0; f < this->FaceVariables.size(); ++f)
  {
    std::copy_n(&faceEdges[3 * f], 3, this->FaceVariables[f].begin());
  }
  this->SetVariables(static_cast<std::size_t>(edges.GetNumberOfEdges()));
  for (std::size_t v = 0; v < this->AreBorder.size(); ++v)
  {
    this->AreBorder[v] = this->Starts[v + 1] - this->Starts[v] == 1 ? 1 : 0;
  }
}

void LevelSearch::UsePoints(const DisplacedFaces& faces, std::size_t numberOfPoints)
{
  this->ArePoints = true;
  this->FaceVariables.resize(static_cast<std::size_t>(faces.GetNumberOfFaces()));
  std::vector<std::array<int, 2>> edges;
  for (std::size_t f = 0; f < this->FaceVariables.size(); ++f)
  {
    this->FaceVariables[f] = faces.GetMergedPoints(static_cast<int>(f));
    for (const auto& ends : EdgeCorners)
    {
      const auto both =
        std::minmax(this->FaceVariables[f][ends[0]], this->FaceVariables[f][ends[1]]);
      edges.push_back({ both.first, both.second });
    }
  }
  this->SetVariables(numberOfPoints);
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if (next - edge == 1)
    {
      this->AreBorder[(*edge)[0]] = this->AreBorder[(*edge)[1]] = 1;
    }
    edge = next;
  }
}

void LevelSearch::SetVariables(std::size_t number)
{
  this->Starts.assign(number + 1, 0);
  for (const Variables& variables : this->FaceVariables)
  {
    for (int v : variables)
    {
      ++this->Starts[v + 1];
    }
  }
  for (std::size_t v = 0; v < number; ++v)
  {
    this->Starts[v + 1] += this->Starts[v];
  }
  this->Uses.resize(3 * this->FaceVariables.size());
  std::vector<int> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t f = 0; f < this->FaceVariables.size(); ++f)
  {
    for (int v : this->FaceVariables[f])
    {
      this->Uses[next[v]++] = static_cast<int>(f);
    }
  }
  this->AreBorder.assign(number, 0);
}

void LevelSearch::FixBorder()
{
  for (std::size_t v = 0; this->HasFixedBorder && v < this->AreBorder.size(); ++v)
  {
    if (this->AreBorder[v])
    {
      this->VariableSteps[v] = this->HighestStep;
    }
  }
}

// With geomorphing, half a level is added: vertices of the step are then in their final position,
// and those of the next step have not started to move.
float LevelSearch::GetTagOfStep(int step) const
{
  const auto level =
    static_cast<float>(std::log2(double(this->Family->GetSegmentSteps().GetSegments(step))));
  return this->Family->IsMorphing() ? std::nextafter(level + 0.5f, 0.0f) : level;
}

std::array<float, 3> LevelSearch::GetTags(int face) const
{
  const Variables& variables = this->FaceVariables[face];
  std::array<float, 3> tags;
  for (int i = 0; i < 3; ++i)
  {
    tags[i] = this->StepTags[this->VariableSteps[variables[i]]];
  }
  if (!this->ArePoints)
  {
    return tags;
  }
  std::array<float, 3> means;
  for (int e = 0; e < 3; ++e)
  {
    means[e] = meanTag(tags[EdgeCorners[e][0]], tags[EdgeCorners[e][1]]);
  }
  return means;
}

void LevelSearch::MeasureFaces(DisplacedFaces& faces, const std::vector<int>& which)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(which.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const int f = which[i];
        const FaceDeviations found = faces.Measure(f, this->GetTags(f));
        this->Deviations[f] = { { found.Edges[0], found.Edges[1], found.Edges[2], found.Inside } };
      }
    });
}

bool LevelSearch::CanRaise(int variable) const
{
  return this->VariableSteps[variable] < this->HighestStep;
}

// Smooth surfaces deviate by the square of the segments' length. Rough ones need more segments than
// this, which the next measurement shows.
void LevelSearch::Raise(int variable, double excess)
{
  const SegmentSteps& steps = this->Family->GetSegmentSteps();
  const int step = this->VariableSteps[variable];
  const double growth = std::min(std::sqrt(excess), 1024.0);
  const int wanted = static_cast<int>(growth * steps.GetSegments(step));
  int next = steps.FindStep(wanted);
  next = steps.GetSegments(next) > wanted ? next - 1 : next;
  next = std::min(std::max(next, step + 1), this->HighestStep);
  if (next > this->NextSteps[variable])
  {
    if (this->NextSteps[variable] == step)
    {
      this->Raised.push_back(variable);
    }
    this->NextSteps[variable] = next;
  }
}

void LevelSearch::RaiseLowest(const int* variables, std::size_t number, double excess)
{
  int lowest = this->HighestStep;
  for (std::size_t i = 0; i < number; ++i)
  {
    lowest = std::min(lowest, this->VariableSteps[variables[i]]);
  }
  for (std::size_t i = 0; i < number && lowest < this->HighestStep; ++i)
  {
    if (this->VariableSteps[variables[i]] == lowest)
    {
      this->Raise(variables[i], excess);
    }
  }
}

void LevelSearch::RaiseFace(int face)
{
  const double limit = (*this->Limits)[face];
  const std::array<float, 4>& deviations = this->Deviations[face];
  const auto getExcess = [limit](double deviation)
  { return deviation <= limit ? 1.0 : std::min(deviation / limit, MaximumExcess); };
  const Variables& variables = this->FaceVariables[face];
  const std::size_t raised = this->Raised.size();
  bool isRaised = false;
  for (int e = 0; e < 3; ++e)
  {
    const double excess = getExcess(deviations[e]);
    if (!(excess > 1.0))
    {
      continue;
    }
    if (this->ArePoints)
    {
      const int ends[2] = { variables[EdgeCorners[e][0]], variables[EdgeCorners[e][1]] };
      isRaised = isRaised || this->CanRaise(ends[0]) || this->CanRaise(ends[1]);
      this->RaiseLowest(ends, 2, excess);
    }
    else if (this->CanRaise(variables[e]))
    {
      isRaised = true;
      this->Raise(variables[e], excess);
    }
  }
  if (!isRaised && raised == this->Raised.size())
  {
    const double excess = getExcess(*std::max_element(deviations.begin(), deviations.end()));
    if (excess > 1.0)
    {
      this->RaiseLowest(variables.data(), 3, excess);
    }
  }
}

std::vector<int> LevelSearch::FindFacesOfRaised()
{
  std::vector<int> faces;
  for (int v : this->Raised)
  {
    this->VariableSteps[v] = this->NextSteps[v];
    faces.insert(
      faces.end(), this->Uses.begin() + this->Starts[v], this->Uses.begin() + this->Starts[v + 1]);
  }
  this->Raised.clear();
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void LevelSearch::Run(DisplacedFaces& faces, const PatternFamily& family,
  const std::vector<double>& limits, int highestLevel)
{
  const SegmentSteps& steps = family.GetSegmentSteps();
  this->Family = &family;
  this->Limits = &limits;
  this->HighestStep = steps.FindStep(1 << highestLevel);
  this->StepTags.clear();
  for (int step = 0; step <= this->HighestStep; ++step)
  {
    this->StepTags.push_back(std::min(this->GetTagOfStep(step), static_cast<float>(highestLevel)));
  }
  this->VariableSteps.assign(this->Starts.size() - 1, 0);
  this->FixBorder();
  this->NextSteps = this->VariableSteps;
  this->Deviations.resize(this->FaceVariables.size());
  std::vector<int> which(this->FaceVariables.size());
  for (std::size_t f = 0; f < which.size(); ++f)
  {
    which[f] = static_cast<int>(f);
  }
  while (!which.empty())
  {
    this->MeasureFaces(faces, which);
    for (int f : which)
    {
      this->RaiseFace(f);
    }
    which = this->FindFacesOfRaised();
  }
}

float LevelSearch::GetTag(int variable) const
{
  const int step = this->VariableSteps[variable];
  double excess = 1.0;
  for (int i = this->Starts[variable]; step == this->HighestStep && i < this->Starts[variable + 1];
       ++i)
  {
    const std::array<float, 4>& deviations = this->Deviations[this->Uses[i]];
    const double limit = (*this->Limits)[this->Uses[i]];
    const double deviation = *std::max_element(deviations.begin(), deviations.end());
    if (deviation > limit)
    {
      excess = std::max(excess, std::min(deviation / limit, MaximumExcess));
    }
  }
  return this->GetTagOfStep(step) + static_cast<float>(0.5 * std::log2(excess));
}
}
