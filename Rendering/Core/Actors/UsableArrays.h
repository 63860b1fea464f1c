// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which arrays of a mesh VTK's mapper can take
 *
 * It assumes that an array has a tuple for each point or cell, and reads past its end
 * where there are fewer. Private to the modules.
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
/// Takes arrays of points and cells that have too few tuples from a mesh, and the roles of normals,
/// tangents and texture coordinates from arrays whose number of components is none of theirs.
/// Returns what to tell users, empty where all arrays are left.
RELEVORENDERINGCORE_EXPORT std::string RemoveUnusableArrays(vtkPolyData* mesh);

/// The values that a mapper colours by.
struct ScalarMapping
{
  vtkDataSet* Input;
  vtkAbstractArray* Scalars;
  int CellFlag; // as vtkAbstractMapper::GetAbstractScalars() has it
  int ColorMode;
  vtkIdType FieldTuple; // of field data, the one that counts; -1 for one for each cell
};

/// Why vtkMapper::MapScalars() cannot be asked, empty where it can.
RELEVORENDERINGCORE_EXPORT std::string FindMappingError(const ScalarMapping& mapping);
}

#endif
