// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PixelRays
 * @brief   camera rays through pixel centres, in world coordinates
 *
 * Rays start at the near plane of the camera and end at its far plane.
 *
 * Private to the module.
 */
#ifndef PixelRays_h
#define PixelRays_h

#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

class vtkCamera;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT PixelRays
{
public:
  PixelRays(vtkCamera* camera, int width, int height);

  /// Row 0 is at the bottom. Fractions are positions between pixel centres.
  Ray Make(double column, double row) const;

private:
  int Size[2];
  dmat4 ViewToWorld;
  dmat4 ClipToView;
};
}

#endif
