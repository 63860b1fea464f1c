// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LocalPoints
 * @brief   the points of a mesh as floats that keep the digits of large coordinates
 *
 * Points that are floats stay as they are. Others become floats relative to the middle of the
 * finite ones, or of those of the whole surface that they are a piece of. The same place has the
 * same bits: there is no -0.
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
/// The box of points; nullptr for none.
RELEVOFILTERSCORE_EXPORT FiniteBox MeasurePoints(vtkPoints* points);

class RELEVOFILTERSCORE_EXPORT LocalPoints
{
public:
  /// Take the points, nullptr for none. `whole` is the box of a surface that they are a piece of.
  void Build(vtkPoints* points, const FiniteBox* whole = nullptr);

  vtkIdType GetNumberOfPoints() const
  {
    return static_cast<vtkIdType>(this->Coordinates.size() / 3);
  }

  /// Subtracted from the points before they became floats; zero for points that are floats.
  double Origin[3] = { 0.0, 0.0, 0.0 };
  /// 3 floats per point.
  std::vector<float> Coordinates;
};
}

#endif
