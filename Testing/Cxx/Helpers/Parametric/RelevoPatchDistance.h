// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures distances of points from the patches of a mesh, in model units and in pixels.
#ifndef RelevoPatchDistance_h
#define RelevoPatchDistance_h

#include "RelevoSplines.h"

#include "vtkCellLocator.h"
#include "vtkPolyData.h"

class vtkCamera;
class vtkDataSet;

/// Looks from above and aside and shows everything, like a renderer's ResetCamera().
void RelevoLookAt(vtkDataSet* data, vtkCamera* camera);

class RelevoPatchDistance
{
public:
  /// Evaluates the patches of a mesh by their definition and splits them into this many parts per
  /// direction.
  explicit RelevoPatchDistance(vtkPolyData* mesh, int parts = 96);

  /// All patches with this many parts per direction, each of two triangles.
  vtkSmartPointer<vtkPolyData> Cut(int parts) const;

  /// Distance of a point from the nearest triangle of the parts.
  double Measure(const RelevoPosition& x) const;

  /// Largest distance of the centres of triangles and of their edges, in pixels of a viewport of
  /// this height at each point's depth. Measures one triangle in every `stride`.
  double MeasurePixels(vtkPolyData* refined, vtkCamera* camera, int height, int stride = 1) const;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkCellLocator> Locator;
};

#endif
