// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Blending
 * @brief   from what a ray passes through to the colour of a pixel
 *
 * Private to the module's own sources.
 */
#ifndef Blending_h
#define Blending_h

#include "Cells/Ray.h"
#include "Rays/IsoSurfaces.h"

#include <vector>

namespace relevo
{
/// By vtkVolumeMapper's numbers.
enum class BlendMode
{
  Composite,
  Maximum,
  Minimum,
  Average,
  Additive,
  IsoSurface
};

class Blending
{
public:
  /// Composite and IsoSurface show the surfaces, IsoSurface nothing else.
  Blending(const TransferFunctions& functions, BlendMode mode, const IsoSurfaces& surfaces)
    : Functions(functions)
    , Mode(mode)
    , Surfaces(surfaces)
  {
  }

  /// Premultiplied.
  dvec4 Blend(const std::vector<RayPart>& parts) const;

private:
  dvec4 BlendComposite(const std::vector<RayPart>& parts) const;
  dvec4 BlendIsoSurfaces(const std::vector<RayPart>& parts) const;
  dvec4 BlendAdditive(const std::vector<RayPart>& parts) const;

  const TransferFunctions& Functions;
  const BlendMode Mode;
  const IsoSurfaces& Surfaces;
};
}

#endif
