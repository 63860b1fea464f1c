// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/ClippingPlanes.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <algorithm>

namespace relevo
{
ClippingPlanes::ClippingPlanes(vtkPlaneCollection* planes)
{
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    auto* plane = vtkPlane::SafeDownCast(planes->GetItemAsObject(i));
    Plane read;
    plane->GetOrigin(&read.Origin.x);
    plane->GetNormal(&read.Normal.x);
    this->Planes.push_back(read);
  }
}

Ray ClippingPlanes::Clip(const Ray& ray) const
{
  double begin = 0.0;
  double end = ray.Length;
  for (const Plane& plane : this->Planes)
  {
    const double height = dot(ray.Origin - plane.Origin, plane.Normal);
    const double slope = dot(ray.Direction, plane.Normal);
    if (slope > 0.0)
    {
      begin = std::max(begin, -height / slope);
    }
    else if (slope < 0.0)
    {
      end = std::min(end, -height / slope);
    }
    else if (!(height >= 0.0))
    {
      end = begin;
    }
  }
  return begin < end ? Ray{ ray.Origin + begin * ray.Direction, ray.Direction, end - begin }
                     : Ray{ ray.Origin, ray.Direction, 0.0 };
}
}
