// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   removes arrays that VTK's mapper cannot use from a mesh
 *
 * VTK's mapper assumes that an array has a tuple for each point or cell, and reads past the end of
 * shorter arrays. Private to the modules.
 */
#ifndef UsableArrays_h
#define UsableArrays_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkType.h"

#include <string>

class vtkAbstractArray;
class vtkDataSet;
class vtkPolyData;

namespace relevo
{
/// Remove point and cell arrays with too few tuples from a mesh, and the attribute types normals,
/// tangents and texture coordinates from arrays with a wrong number of components.
RELEVORENDERINGCORE_EXPORT std::string RemoveUnusableArrays(vtkPolyData* mesh);

/// The values that a mapper maps to colours.
struct ScalarMapping
{
  vtkDataSet* Input;
  vtkAbstractArray* Scalars;
  int CellFlag; // from vtkAbstractMapper::GetAbstractScalars()
  int ColorMode;
  vtkIdType FieldTuple; // the tuple of field data; -1 for one tuple per cell
};

/// Return why vtkMapper::MapScalars() must not be called; empty if it can be.
RELEVORENDERINGCORE_EXPORT std::string FindMappingError(const ScalarMapping& mapping);
}

#endif
