// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Light along a ray through a cube, summed over pieces so short that values are constant in each.
// Isosurfaces lie wherever the scalar passes a value between two pieces.
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

  // May shorten the ray.
  std::function<void(const RelevoRay&, double& begin, double& end)> Clip;

  // Premultiplied. Additive means without absorption, at most 1.
  RelevoColor Composite(const RelevoRay& ray) const;
  RelevoColor Add(const RelevoRay& ray) const;
  // Lowest, highest and mean scalar. Returns false if there is none.
  bool Measure(const RelevoRay& ray, double& low, double& high, double& mean) const;

  bool Cut(const RelevoRay& ray, double& begin, double& end) const;
};

// Row after row of `get` for each ray.
std::vector<RelevoColor> MakePicture(vtkCamera* camera, int width, int height,
  const std::function<RelevoColor(const RelevoRay&)>& get);

// Straight colour and opacity by the functions of a component.
RelevoColor MapScalar(vtkVolumeProperty* property, double scalar, int component = 0);
RelevoColor Premultiply(const RelevoColor& color);

#endif
