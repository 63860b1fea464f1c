// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Blending
 * @brief   computes the colour of a pixel from the parts of its ray
 *
 * Private to the module.
 */
#ifndef Blending_h
#define Blending_h

#include "Integral/CurveIntegral.h"
#include "Integral/Ray.h"
#include "Rays/BlendMode.h"
#include "Rays/IsoSurfaces.h"
#include "Rays/Shading.h"

#include <optional> // for a member
#include <vector>

namespace relevo
{
class Blending
{
public:
  /// Composite and IsoSurface draw the surfaces, which are shaded as well. IsoSurface draws nothing
  /// else.
  Blending(const TransferFunctions& functions, BlendMode mode, const IsoSurfaces& surfaces,
    const Shading& shading)
    : Functions(functions)
    , Mode(mode)
    , Surfaces(surfaces)
    , Shades(shading)
    , IsShaded(shading.IsOn())
  {
    const bool isComposite =
      mode == BlendMode::Composite && surfaces.GetValues().empty() && !this->IsShaded;
    if ((isComposite || this->IsAdditive()) && functions.DependOnOneScalar())
    {
      this->Integral.emplace(functions);
    }
  }

  bool IsAdditive() const { return this->Mode == BlendMode::Additive; }

  /// Returns the integral that replaces Blend() where colours depend on one scalar, or null.
  const CurveIntegral* FindCurveIntegral() const
  {
    return this->Integral ? &*this->Integral : nullptr;
  }

  /// Returns the premultiplied colour of a ray.
  dvec4 Blend(const std::vector<RayPart>& parts, const dvec3& direction) const;

private:
  dvec4 BlendComposite(const std::vector<RayPart>& parts, const dvec3& direction) const;
  dvec4 BlendIsoSurfaces(const std::vector<RayPart>& parts, const dvec3& direction) const;
  dvec4 BlendAdditive(const std::vector<RayPart>& parts) const;
  Segment Light(const RayPart& part, const dvec3& direction) const;
  dvec4 ShowSurface(const RayPart& part, const IsoCrossing& crossing, const dvec3& direction) const;

  const TransferFunctions& Functions;
  const BlendMode Mode;
  const IsoSurfaces& Surfaces;
  const Shading& Shades;
  const bool IsShaded;
  std::optional<CurveIntegral> Integral;
};
}

#endif
