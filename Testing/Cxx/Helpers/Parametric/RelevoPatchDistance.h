// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// How far points are from the patches of a mesh, and how many pixels that is.
#ifndef RelevoPatchDistance_h
#define RelevoPatchDistance_h

#include "RelevoSplines.h"

#include "vtkCellLocator.h"
#include "vtkPolyData.h"

class vtkCamera;
class vtkDataSet;

/// From above and aside, all of it in the picture, as a renderer's ResetCamera() has it.
void RelevoLookAt(vtkDataSet* data, vtkCamera* camera);

class RelevoPatchDistance
{
public:
  /// Of the patches that a mesh carries, by their definition, cut into so many parts each way.
  explicit RelevoPatchDistance(vtkPolyData* mesh, int parts = 96);

  /// All patches in so many parts each way, of two triangles each.
  vtkSmartPointer<vtkPolyData> Cut(int parts) const;

  /// From a point to the nearest triangle of the parts.
  double Measure(const RelevoPosition& x) const;

  /// The largest such distance of middles of triangles and of their edges, in pixels of a viewport
  /// of this height, each at its own depth; of one triangle in every `stride`.
  double MeasurePixels(vtkPolyData* refined, vtkCamera* camera, int height, int stride = 1) const;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkCellLocator> Locator;
};

#endif
