// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PixelRays
 * @brief   the rays of a camera through the centres of pixels, in world coordinates
 *
 * From the camera's near plane to its far one.
 *
 * Private to the module's own sources.
 */
#ifndef PixelRays_h
#define PixelRays_h

#include "Cells/Ray.h"

class vtkCamera;

namespace relevo
{
class PixelRays
{
public:
  PixelRays(vtkCamera* camera, int width, int height);

  /// Row 0 is the lowest.
  Ray Make(int column, int row) const;

private:
  int Size[2];
  dmat4 ViewToWorld;
  dmat4 ClipToView;
};
}

#endif
