// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkFrames
 * @brief   frame times of several mappers, drawn in turn from the same positions
 *
 * In each round the camera moves, and every mapper or prop draws one frame alone. The order
 * changes, because a frame takes longer after another mapper's large one. Ratios compare frames of
 * the same round, so that the load of other programs cancels.
 */
#ifndef BenchmarkFrames_h
#define BenchmarkFrames_h

#include "vtkSmartPointer.h"

#include <functional>
#include <random>
#include <vector>

class BenchmarkView;
class vtkMapper;
class vtkProp;

class BenchmarkFrames
{
public:
  /// Draws each mapper once to warm up, and calls `onFirst` with its number after its frame.
  BenchmarkFrames(BenchmarkView& view, const std::vector<vtkMapper*>& mappers,
    const std::function<void(size_t)>& onFirst = {});
  /// The same for props, drawn twice.
  BenchmarkFrames(BenchmarkView& view, const std::vector<vtkProp*>& props);
  /// Removes the mappers from the view.
  ~BenchmarkFrames();
  BenchmarkFrames(const BenchmarkFrames&) = delete;
  void operator=(const BenchmarkFrames&) = delete;

  /// Measures this many rounds. A mapper takes part until its frames have used `seconds`, but at
  /// least in the first `minimum` rounds.
  void Measure(int rounds, int minimum = 1, double seconds = 1e9);
  /// The angle in degrees that the camera turns per round, 0.5 by default.
  void SetTurn(double degrees) { this->Turn = degrees; }

  /// Milliseconds, or NaN without measurements.
  double GetMedian(size_t mapper) const;
  double GetMinimum(size_t mapper) const;
  double GetMaximum(size_t mapper) const;
  /// Median ratio of a mapper's frames to those of another, over the rounds of both.
  double GetRatio(size_t mapper, size_t reference) const;
  /// The same ratio for GetProcessorSeconds().
  double GetProcessorRatio(size_t mapper, size_t reference) const;

private:
  struct Frame
  {
    double Milliseconds;
    double ProcessorSeconds;
  };
  void DrawFirst(const std::function<void(size_t)>& onFirst);
  Frame DrawFrame(size_t mapper);
  std::vector<double> Get(size_t mapper, double Frame::*figure) const;

  BenchmarkView& View;
  std::mt19937 Random; // with a fixed seed
  double Turn = 0.5;
  std::vector<vtkSmartPointer<vtkProp>> Props;
  std::vector<std::vector<Frame>> Frames; // one list per mapper
};

#endif
