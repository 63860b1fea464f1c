// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFrames.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkView.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProp.h"
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
    this->Props.push_back(view.AddActor(mapper));
  }
  this->DrawFirst(onFirst);
}

BenchmarkFrames::BenchmarkFrames(BenchmarkView& view, const std::vector<vtkProp*>& props)
  : View(view)
  , Props(props.begin(), props.end())
  , Frames(props.size())
{
  for (vtkProp* prop : props)
  {
    view.GetRenderer()->AddViewProp(prop);
  }
  // Drivers compile shaders again if another prop has left another state.
  this->DrawFirst({});
  this->DrawFirst({});
}

BenchmarkFrames::~BenchmarkFrames()
{
  for (vtkProp* prop : this->Props)
  {
    this->View.GetRenderer()->RemoveViewProp(prop);
  }
}

void BenchmarkFrames::DrawFirst(const std::function<void(size_t)>& onFirst)
{
  for (vtkProp* prop : this->Props)
  {
    prop->VisibilityOff();
  }
  this->View.MoveCamera(this->Turn);
  for (size_t m = 0; m < this->Props.size(); ++m)
  {
    this->DrawFrame(m);
    if (onFirst)
    {
      onFirst(m);
    }
  }
}

void BenchmarkFrames::Measure(int rounds, int minimum, double seconds)
{
  std::vector<size_t> order(this->Props.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> taken(this->Props.size(), 0.0);
  for (int round = 0; round < rounds; ++round)
  {
    this->View.MoveCamera(this->Turn);
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
  this->Props[mapper]->VisibilityOn();
  const double start = GetProcessorSeconds();
  const double seconds = this->View.TimeFrame();
  const Frame frame = { 1e3 * seconds, GetProcessorSeconds() - start };
  this->Props[mapper]->VisibilityOff();
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

double BenchmarkFrames::GetMinimum(size_t mapper) const
{
  const std::vector<double> values = this->Get(mapper, &Frame::Milliseconds);
  return *std::min_element(values.begin(), values.end());
}

double BenchmarkFrames::GetMaximum(size_t mapper) const
{
  const std::vector<double> values = this->Get(mapper, &Frame::Milliseconds);
  return *std::max_element(values.begin(), values.end());
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
