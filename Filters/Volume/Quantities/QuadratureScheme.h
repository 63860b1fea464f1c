// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   QuadratureScheme
 * @brief   which values of a field array belong to which integration points of the cells
 *
 * VTK stores values at integration points as arrays of the field data. An array refers to a cell
 * array of offsets by vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME(). The offset of
 * a cell is the tuple of its first point. The information of the offsets has a
 * vtkQuadratureSchemeDefinition for each type of cell.
 */
#ifndef QuadratureScheme_h
#define QuadratureScheme_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkQuadratureSchemeDefinition;

namespace relevo
{
class QuadratureScheme
{
public:
  /// Check all cells. Both objects must outlive this one.
  QuadratureScheme(vtkDataSet* data, vtkDataArray* values);

  /// A fault of the array, its offsets or its definitions; "" for none.
  const std::string& GetError() const { return this->Error; }

  /// The definition of a cell, or nullptr if it has no integration points.
  vtkQuadratureSchemeDefinition* GetDefinition(vtkIdType cell) const;
  /// The tuple of a cell's first point.
  vtkIdType GetFirst(vtkIdType cell) const;

private:
  void Check(vtkDataArray* values);

  vtkDataSet* Data;
  vtkDataArray* Offsets = nullptr;
  std::vector<vtkQuadratureSchemeDefinition*> Definitions; // by type of cell
  std::string Error;
};

/// The field arrays of values at integration points.
std::vector<vtkDataArray*> FindIntegrationPointArrays(vtkDataSet* data);
}

#endif
