// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFrames.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkView.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <numeric>

BenchmarkFrames::BenchmarkFrames(BenchmarkView& view, const std::vector<vtkMapper*>& mappers,
  const std::function<void(size_t)>& onFirst)
  : View(view)
  , Frames(mappers.size())
{
  for (vtkMapper* mapper : mappers)
  {
    this->Actors.push_back(view.AddActor(mapper));
    this->Actors.back()->VisibilityOff();
  }
  view.MoveCamera();
  for (size_t m = 0; m < mappers.size(); ++m)
  {
    this->DrawFrame(m);
    if (onFirst)
    {
      onFirst(m);
    }
  }
}

BenchmarkFrames::~BenchmarkFrames()
{
  for (vtkActor* actor : this->Actors)
  {
    this->View.GetRenderer()->RemoveActor(actor);
  }
}

void BenchmarkFrames::Measure(int rounds, int minimum, double seconds)
{
  std::vector<size_t> order(this->Actors.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> taken(this->Actors.size(), 0.0);
  for (int round = 0; round < rounds; ++round)
  {
    this->View.MoveCamera();
    std::shuffle(order.begin(), order.end(), this->Random);
    for (const size_t m : order)
    {
      if (round < minimum || taken[m] < seconds)
      {
        this->Frames[m].push_back(this->DrawFrame(m));
        taken[m] += 1e-3 * this->Frames[m].back().Milliseconds;
      }
    }
  }
}

BenchmarkFrames::Frame BenchmarkFrames::DrawFrame(size_t mapper)
{
  this->Actors[mapper]->VisibilityOn();
  const double start = GetProcessorSeconds();
  const double seconds = this->View.TimeFrame();
  const Frame frame = { 1e3 * seconds, GetProcessorSeconds() - start };
  this->Actors[mapper]->VisibilityOff();
  return frame;
}

std::vector<double> BenchmarkFrames::Get(size_t mapper, double Frame::*figure) const
{
  std::vector<double> figures;
  for (const Frame& frame : this->Frames[mapper])
  {
    figures.push_back(frame.*figure);
  }
  return figures;
}

double BenchmarkFrames::GetMedian(size_t mapper) const
{
  return ::GetMedian(this->Get(mapper, &Frame::Milliseconds));
}

double BenchmarkFrames::GetRatio(size_t mapper, size_t reference) const
{
  return GetMedianRatio(
    this->Get(mapper, &Frame::Milliseconds), this->Get(reference, &Frame::Milliseconds));
}

double BenchmarkFrames::GetProcessorRatio(size_t mapper, size_t reference) const
{
  return GetMedianRatio(
    this->Get(mapper, &Frame::ProcessorSeconds), this->Get(reference, &Frame::ProcessorSeconds));
}
