// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ClippingPlanes
 * @brief   what planes leave of a ray: what is on the positive side of all of them
 *
 * Private to the module's own sources.
 */
#ifndef ClippingPlanes_h
#define ClippingPlanes_h

#include "Cells/Ray.h"

#include <vector>

class vtkPlaneCollection;

namespace relevo
{
class ClippingPlanes
{
public:
  /// Null for none.
  explicit ClippingPlanes(vtkPlaneCollection* planes);

  /// A length of 0 if nothing is left.
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
