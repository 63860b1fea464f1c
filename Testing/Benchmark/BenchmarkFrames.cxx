// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFrames.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkView.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkRenderer.h"

BenchmarkFrames::BenchmarkFrames(BenchmarkView& view, const std::vector<vtkMapper*>& mappers,
  const std::function<void(size_t)>& onFirst)
  : View(view)
  , Times(mappers.size())
  , ProcessorTimes(mappers.size())
{
  for (vtkMapper* mapper : mappers)
  {
    this->Actors.push_back(view.AddActor(mapper));
    this->Actors.back()->VisibilityOff();
  }
  view.MoveCamera();
  for (size_t m = 0; m < mappers.size(); ++m)
  {
    this->DrawFrame(m, false);
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
  const Stopwatch watch;
  for (int round = 0; round < rounds && (round < minimum || watch.GetSeconds() < seconds); ++round)
  {
    this->View.MoveCamera();
    for (size_t m = 0; m < this->Actors.size(); ++m)
    {
      this->DrawFrame(m, true);
    }
  }
}

void BenchmarkFrames::DrawFrame(size_t mapper, bool isMeasured)
{
  this->Actors[mapper]->VisibilityOn();
  const double start = GetProcessorSeconds();
  const double seconds = this->View.TimeFrame();
  if (isMeasured)
  {
    this->ProcessorTimes[mapper].push_back(GetProcessorSeconds() - start);
    this->Times[mapper].push_back(1e3 * seconds);
  }
  this->Actors[mapper]->VisibilityOff();
}

double BenchmarkFrames::GetMedian(size_t mapper) const
{
  return ::GetMedian(this->Times[mapper]);
}

double BenchmarkFrames::GetRatio(size_t mapper, size_t reference) const
{
  return GetMedianRatio(this->Times[mapper], this->Times[reference]);
}

double BenchmarkFrames::GetProcessorRatio(size_t mapper, size_t reference) const
{
  return GetMedianRatio(this->ProcessorTimes[mapper], this->ProcessorTimes[reference]);
}
