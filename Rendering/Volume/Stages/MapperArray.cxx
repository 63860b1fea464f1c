// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/MapperArray.h"

#include "Integral/TransferFunctions.h" // for the number of components
#include "vtkAbstractMapper.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"

namespace relevo
{
namespace
{
std::string AdviseScalarMode(int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? "Use SetScalarModeToUseCellFieldData()"
    : "Use SetScalarModeToUsePointFieldData()";
}
}

ArrayRequest MakeArrayRequest(const MapperArray& array, bool takesAll)
{
  const auto find = [array](vtkDataSet* mesh, int& association)
  {
    int kind = 0;
    vtkDataArray* found =
      vtkAbstractMapper::GetScalars(mesh, array.ScalarMode, array.ArrayAccessMode, array.ArrayId,
        array.ArrayName.empty() ? nullptr : array.ArrayName.c_str(), kind);
    association =
      kind == 1 ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    return kind == 2 ? nullptr : found;
  };
  const bool isByName = array.ArrayAccessMode == VTK_GET_ARRAY_BY_NAME &&
    array.ScalarMode >= VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  const int association = array.ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
    ? vtkDataObject::FIELD_ASSOCIATION_CELLS
    : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return { find, isByName ? array.ArrayName : "", association, AdviseScalarMode,
    takesAll ? MaximumComponents : VTK_INT_MAX, "SelectScalarArray()" };
}
}
