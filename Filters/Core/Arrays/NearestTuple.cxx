// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/NearestTuple.h"

#include "Mathematics/NearestNumber.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayAccessor.h"

#include <cmath>

namespace relevo
{
namespace
{
struct TupleSetter
{
  vtkIdType Tuple;
  const double* Values;

  template <typename ArrayT>
  void operator()(ArrayT* array) const
  {
    using T = typename vtkDataArrayAccessor<ArrayT>::APIType;
    vtkDataArrayAccessor<ArrayT> values(array);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isnan(this->Values[c]) || !HoldsIntegers(array))
      {
        values.Set(this->Tuple, c, getNearestNumber<T>(this->Values[c]));
      }
    }
  }
};
}

bool HoldsIntegers(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

void SetNearestTuple(vtkDataArray* array, vtkIdType tuple, const double* values)
{
  const TupleSetter set{ tuple, values };
  if (!vtkArrayDispatch::Dispatch::Execute(array, set))
  {
    set(array);
  }
}
}
