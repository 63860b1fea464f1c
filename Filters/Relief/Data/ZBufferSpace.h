// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ZBufferSpace
 * @brief   conversion of pixels and z-buffer values to texels and depths of a relief
 *
 * Pixels are at their centres. z is 0 at the near plane and 1 at the far plane. The matrices of the
 * camera are used, so that oblique, off-axis and explicit projections are supported. Depths are
 * distances along the axis of the camera. In parallel projection an offset is subtracted.
 *
 * Private to the modules.
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

  /// Whether the projection of the camera is invertible.
  bool IsRegular() const;
  ReliefProjection GetProjection() const { return this->Projection; }
  /// Returns the depth without the offset.
  double GetDepth(int column, int row, double z) const;
  /// Returns the ReliefMatrix. `offset` is subtracted from depths of a parallel projection.
  dmat4 GetMatrix(double offset) const;

private:
  ReliefProjection Projection;
  dmat4 PixelToWorld; // from (column, row, z, 1)
  dvec4 ToHeight;     // from (column, row, z, 1) to 1 / depth in perspective, otherwise to the
                      // depth
};
}

#endif
