// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/NoDataTuples.h"

#include "Arrays/VectorData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <limits>

namespace relevo
{
bool CanLackData(vtkDataSetAttributes* data, vtkDataArray* array)
{
  return array != data->GetNormals() && array != data->GetTCoords() && array != data->GetTangents();
}

NoDataTuples::NoDataTuples(vtkDataArray* array, double noDataMagnitude)
{
  const int components = array->GetNumberOfComponents();
  const bool isVector = components == 2 || components == 3;
  if (components != 1 && !isVector)
  {
    return; // arrays with other numbers of components have no missing values
  }
  // Infinity is not less than infinity, so infinite numbers are missing values.
  const double limit = isVector ? noDataMagnitude : std::numeric_limits<double>::infinity();
  this->Marks.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  std::atomic<bool> any(false);
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      bool found = false;
      double tuple[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        array->GetTuple(i, tuple);
        const bool isNoData = !IsVectorData(tuple, components, limit);
        this->Marks[static_cast<std::size_t>(i)] = isNoData ? 1 : 0;
        found = found || isNoData;
      }
      if (found)
      {
        any = true;
      }
    });
  if (!any)
  {
    this->Marks = {};
  }
}
}
