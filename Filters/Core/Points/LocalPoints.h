// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LocalPoints
 * @brief   the points of a mesh as floats, without loss of precision for large coordinates
 *
 * Float points do not change. Other points become floats relative to the middle of the finite
 * points, or of the points of the whole surface that they are a piece of. Coincident points have
 * the same bits: there is no -0.
 */
#ifndef LocalPoints_h
#define LocalPoints_h

#include "Mathematics/FiniteBox.h"   // for MeasurePoints()
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

#include <vector> // for members

class vtkPoints;

namespace relevo
{
/// The box of points, which may be nullptr.
RELEVOFILTERSCORE_EXPORT FiniteBox MeasurePoints(vtkPoints* points);

class RELEVOFILTERSCORE_EXPORT LocalPoints
{
public:
  /// Set the points, which may be nullptr. `whole` is the box of the surface that they are a piece
  /// of.
  void Build(vtkPoints* points, const FiniteBox* whole = nullptr);

  vtkIdType GetNumberOfPoints() const
  {
    return static_cast<vtkIdType>(this->Coordinates.size() / 3);
  }

  /// The origin that is subtracted from the points before conversion; 0 for float points.
  double Origin[3] = { 0.0, 0.0, 0.0 };
  /// 3 floats per point.
  std::vector<float> Coordinates;
};
}

#endif
