// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Finds the colours of single faces in a picture.
#ifndef RelevoFaceColors_h
#define RelevoFaceColors_h

#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDistanceDepthTagMetric.h"
#include "vtkScalarsToColors.h"

#include <array>
#include <memory>
#include <set>

namespace RelevoFaceColors
{
using RelevoMeshes::Mesh;

using Color = std::array<int, 3>;
using Weights = std::array<double, 3>;

constexpr int MaximumLevel = 4;

Color GetColor(vtkScalarsToColors* table, double value);

bool IsNear(const Color& a, const Color& b, int tolerance);

// A plane without lights, seen at an angle from close by, with levels by distance.
struct View
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkDistanceDepthTagMetric> Metric;
  Mesh Plane;
  std::unique_ptr<RelevoPicture> Picture;

  View();

  void Render();

  // The colour at a point of a face. Returns false if the face is too small on the screen.
  bool GetColorAt(vtkIdType face, const Weights& weights, Color& color);

  std::set<Color> GetColors() const;

private:
  void Project(const double point[3], double display[2]);
};
}

#endif
