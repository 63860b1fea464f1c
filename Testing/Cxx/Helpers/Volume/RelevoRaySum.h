// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What is seen along a ray through a cube, as the sum of so many pieces that each is as good as
// constant; isosurfaces wherever the scalar passes a value from one piece to the next.
#ifndef RelevoRaySum_h
#define RelevoRaySum_h

#include "RelevoVolumes.h"

#include <functional>
#include <vector>

struct RelevoRaySum
{
  RelevoField Scalar;
  // Straight colour and extinction.
  std::function<RelevoColor(const RelevoRay&, const RelevoPoint&)> Optics;
  std::vector<double> Values;
  // Straight colour and opacity.
  std::function<RelevoColor(const RelevoRay&, const RelevoPoint&)> Surface;
  int Count = 4000;

  // The ray may be cut further.
  std::function<void(const RelevoRay&, double& begin, double& end)> Clip;

  // Premultiplied. Additive: without hiding, at most 1.
  RelevoColor Composite(const RelevoRay& ray) const;
  RelevoColor Add(const RelevoRay& ray) const;
  // Lowest, highest and mean scalar; false where there is none.
  bool Measure(const RelevoRay& ray, double& low, double& high, double& mean) const;

  bool Cut(const RelevoRay& ray, double& begin, double& end) const;
};

// Row after row, of what `get` gives for each ray.
std::vector<RelevoColor> MakePicture(vtkCamera* camera, int width, int height,
  const std::function<RelevoColor(const RelevoRay&)>& get);

// Straight colour and opacity of the functions of component 0.
RelevoColor MapScalar(vtkVolumeProperty* property, double scalar, int component = 0);
RelevoColor Premultiply(const RelevoColor& color);

#endif
