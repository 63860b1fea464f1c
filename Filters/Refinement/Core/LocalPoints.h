// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LocalPoints
 * @brief   the points of a mesh as floats that keep the digits of large coordinates
 *
 * Points that are floats stay as they are. Others become floats relative to the middle of the
 * finite ones. The same place has the same bits: there is no -0.
 */
#ifndef LocalPoints_h
#define LocalPoints_h

#include "vtkType.h" // for vtkIdType

#include <vector> // for members

class vtkPoints;

namespace relevo
{
class LocalPoints
{
public:
  /// Take the points; nullptr for none.
  void Build(vtkPoints* points);

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
