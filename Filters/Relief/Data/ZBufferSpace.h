// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ZBufferSpace
 * @brief   the pixels and z-buffer values of a camera as a relief's texels and depths
 *
 * Pixels are at their centres, z is 0 at the near plane and 1 at the far one. By the camera's
 * matrices: oblique, off-axis and explicit projections count. The depth of a perspective is the
 * distance along the camera's axis, that of a parallel projection, too, less an offset.
 *
 * Private to the modules' own sources.
 */
#ifndef ZBufferSpace_h
#define ZBufferSpace_h

#include "Data/Relief.h"
#include "RelevoFiltersReliefModule.h" // for export macro

class vtkCamera;

namespace relevo
{
class RELEVOFILTERSRELIEF_EXPORT ZBufferSpace
{
public:
  ZBufferSpace(vtkCamera* camera, int width, int height);

  /// Whether the camera maps space to pixels at all.
  bool IsRegular() const;
  ReliefProjection GetProjection() const { return this->Projection; }
  /// Before the offset.
  double GetDepth(int column, int row, double z) const;
  /// The ReliefMatrix; the offset is what is taken from the depths of a parallel projection.
  dmat4 GetMatrix(double offset) const;

private:
  ReliefProjection Projection;
  dmat4 PixelToWorld; // from (column, row, z, 1)
  dvec4 ToHeight;     // from (column, row, z, 1): 1 / depth in perspective, else depth
};
}

#endif
