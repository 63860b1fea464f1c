// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkFrames
 * @brief   times of several mappers' frames, drawn in turn from the same places
 *
 * In each round the camera moves on, and every mapper, or prop, draws one frame alone, in an order
 * that changes: a frame takes longer after a large one of another mapper. Frames of a round are
 * compared with one another, so that what else the machine does falls out of the ratios.
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
  /// Draws each mapper once, to warm up, and calls `onFirst` with its number after its frame.
  BenchmarkFrames(BenchmarkView& view, const std::vector<vtkMapper*>& mappers,
    const std::function<void(size_t)>& onFirst = {});
  /// The same for props, twice.
  BenchmarkFrames(BenchmarkView& view, const std::vector<vtkProp*>& props);
  /// Takes the mappers out of the view.
  ~BenchmarkFrames();
  BenchmarkFrames(const BenchmarkFrames&) = delete;
  void operator=(const BenchmarkFrames&) = delete;

  /// That many rounds; a mapper stays out of those after its frames have taken the seconds, but
  /// not of the first `minimum`.
  void Measure(int rounds, int minimum = 1, double seconds = 1e9);
  /// By how many degrees the camera turns in a round: 0.5 unless set.
  void SetTurn(double degrees) { this->Turn = degrees; }

  /// Milliseconds. NaN where nothing was measured.
  double GetMedian(size_t mapper) const;
  double GetMinimum(size_t mapper) const;
  double GetMaximum(size_t mapper) const;
  /// Of a mapper's frames to those of another, in the rounds of both.
  double GetRatio(size_t mapper, size_t reference) const;
  /// The same in GetProcessorSeconds().
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
  std::mt19937 Random; // of one seed
  double Turn = 0.5;
  std::vector<vtkSmartPointer<vtkProp>> Props;
  std::vector<std::vector<Frame>> Frames; // of each mapper
};

#endif
