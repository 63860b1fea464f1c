// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ClippingPlanes
 * @brief   clips rays to the positive side of all planes
 *
 * Private to the module.
 */
#ifndef ClippingPlanes_h
#define ClippingPlanes_h

#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <vector>

class vtkPlaneCollection;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT ClippingPlanes
{
public:
  /// `planes` may be null.
  explicit ClippingPlanes(vtkPlaneCollection* planes);

  /// Returns a ray of length 0 if nothing remains.
  Ray Clip(const Ray& ray) const;

private:
  struct Plane
  {
    dvec3 Origin;
    dvec3 Normal;
  };
  std::vector<Plane> Planes;
};
}

#endif
