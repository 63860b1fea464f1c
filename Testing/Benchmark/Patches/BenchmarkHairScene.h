// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkHairScene
 * @brief   hair on the bunny or a sphere, split uniformly or by its error on the screen
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
  /// The approximate number of hairs. Each is one cubic Bézier curve.
  explicit BenchmarkHairScene(int hairs);
  ~BenchmarkHairScene();

  vtkUnstructuredGrid* GetHairs() const { return this->Hairs; }

  /// The segments of each hair for an error of half a pixel, by vtkAdaptiveCurveFilter.
  std::vector<int> CountSegments(BenchmarkView& view) const;

  /// The largest distance in pixels between visible hairs and their chords.
  double MeasureError(BenchmarkView& view, const std::vector<int>& segments) const;

  /// Poly-lines with this many segments each. Points are floats.
  vtkSmartPointer<vtkPolyData> Cut(int segments) const;

private:
  vtkSmartPointer<vtkUnstructuredGrid> Hairs;
};

#endif
