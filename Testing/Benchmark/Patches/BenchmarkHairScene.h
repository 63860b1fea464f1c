// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkHairScene
 * @brief   hair on the bunny, or a sphere, cut evenly or by its error on the screen
 */
#ifndef BenchmarkHairScene_h
#define BenchmarkHairScene_h

#include "vtkSmartPointer.h"

#include <vector>

class BenchmarkView;
class vtkPolyData;
class vtkUnstructuredGrid;

class BenchmarkHairScene
{
public:
  /// About that many, each one cubic Bézier curve.
  explicit BenchmarkHairScene(int hairs);
  ~BenchmarkHairScene();

  vtkUnstructuredGrid* GetHairs() const { return this->Hairs; }

  /// The segments of each hair, for half a pixel, by vtkAdaptiveCurveFilter.
  std::vector<int> CountSegments(BenchmarkView& view) const;

  /// The largest distance in pixels of hairs in view from their chords.
  double MeasureError(BenchmarkView& view, const std::vector<int>& segments) const;

  /// Poly-lines of so many segments each, points in floats.
  vtkSmartPointer<vtkPolyData> Cut(int segments) const;

private:
  vtkSmartPointer<vtkUnstructuredGrid> Hairs;
};

#endif
