// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/TangentDirections.h"

#include "Geodesy/TangentPlane.h"
#include "vtkSMPTools.h"

#include <limits>

namespace relevo
{
TangentDirections::TangentDirections(const Georeference& system, const MapPlace& origin)
  : Plane(std::make_unique<TangentPlane>(system, origin))
{
}

TangentDirections::~TangentDirections() = default;

void TangentDirections::Evaluate(
  const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const
{
  axes.resize(places.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double longitude;
        double latitude;
        std::array<double, 9> m;
        if (!this->Plane->ToEllipsoid(places[i], longitude, latitude, m))
        {
          m.fill(std::numeric_limits<double>::quiet_NaN());
        }
        axes[i] = { { m[0], m[3] }, { m[1], m[4] } };
      }
    });
}
}
