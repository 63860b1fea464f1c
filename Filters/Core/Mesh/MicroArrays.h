// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   removes the arrays of micro-meshes from refined meshes, which they do not describe
 */
#ifndef MicroArrays_h
#define MicroArrays_h

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace relevo
{
/// Remove all arrays whose names begin with MicroMesh, if the mesh has displacements of one.
inline void RemoveMicroArrays(vtkPolyData* mesh)
{
  if (!mesh->GetFieldData()->HasArray("MicroMeshDisplacements"))
  {
    return;
  }
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(mesh->GetPointData()),
         static_cast<vtkFieldData*>(mesh->GetCellData()), mesh->GetFieldData() })
  {
    for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      const char* name = data->GetArrayName(i);
      if (name && std::string(name).compare(0, 9, "MicroMesh") == 0)
      {
        data->RemoveArray(i);
      }
    }
  }
}
}

#endif
