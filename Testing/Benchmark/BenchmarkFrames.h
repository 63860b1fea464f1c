// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkFrames
 * @brief   times of several mappers' frames, drawn in turn from the same places
 *
 * In each round the camera moves on, and every mapper draws one frame alone. Frames of a round are
 * compared with one another, so that what else the machine does falls out of the ratios.
 */
#ifndef BenchmarkFrames_h
#define BenchmarkFrames_h

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class BenchmarkView;
class vtkActor;
class vtkMapper;

class BenchmarkFrames
{
public:
  /// Draws each mapper once, to warm up, and calls `onFirst` with its number after its frame.
  BenchmarkFrames(BenchmarkView& view, const std::vector<vtkMapper*>& mappers,
    const std::function<void(size_t)>& onFirst = {});
  /// Takes the mappers out of the view.
  ~BenchmarkFrames();
  BenchmarkFrames(const BenchmarkFrames&) = delete;
  void operator=(const BenchmarkFrames&) = delete;

  /// That many rounds; fewer, but no less than `minimum`, when they have taken the seconds.
  void Measure(int rounds, int minimum = 1, double seconds = 1e9);

  /// Milliseconds. NaN where nothing was measured.
  double GetMedian(size_t mapper) const;
  /// Of a mapper's frames to those of another.
  double GetRatio(size_t mapper, size_t reference) const;
  /// The same in GetProcessorSeconds().
  double GetProcessorRatio(size_t mapper, size_t reference) const;
  int GetNumberOfRounds() const { return static_cast<int>(this->Times[0].size()); }

private:
  void DrawFrame(size_t mapper, bool isMeasured);

  BenchmarkView& View;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<std::vector<double>> Times; // milliseconds
  std::vector<std::vector<double>> ProcessorTimes;
};

#endif
