// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FieldScales
 * @brief   the numbers at the points of a data set as shares of their ranges
 *
 * Private to the module.
 */
#ifndef FieldScales_h
#define FieldScales_h

#include "Integral/Ray.h"
#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace relevo
{
class FieldScales
{
public:
  /// Takes the components of all point arrays of float and double.
  explicit FieldScales(vtkDataSet* data);

  /// The number of groups of up to MaximumComponents numbers.
  int GetNumberOfGroups() const;
  int GetSize(int group) const;
  /// The numbers of a group at a point. Numbers that are not finite are 0.
  Scalars Get(int group, vtkIdType point) const;

private:
  struct Field
  {
    vtkDataArray* Array;
    int Component;
    double Factor;
  };

  std::vector<Field> Fields;
};
}

#endif
