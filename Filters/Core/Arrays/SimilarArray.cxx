// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/SimilarArray.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <string>

namespace relevo
{
bool IsInterpolated(vtkAbstractArray* array)
{
  const char* name = array->GetName();
  return vtkDataArray::SafeDownCast(array) && array->GetDataType() != VTK_BIT &&
    !(name && std::string(name) == vtkDataSetAttributes::GhostArrayName());
}

vtkAbstractArray* AddArrayLike(vtkDataSetAttributes* from, vtkAbstractArray* source,
  vtkDataSetAttributes* to, vtkIdType numberOfTuples)
{
  auto target = vtkSmartPointer<vtkAbstractArray>::Take(source->NewInstance());
  target->SetName(source->GetName());
  target->SetNumberOfComponents(source->GetNumberOfComponents());
  target->CopyComponentNames(source);
  target->CopyInformation(source->GetInformation(), 1);
  target->SetNumberOfTuples(numberOfTuples);
  if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(source))
  {
    vtkDataArray::SafeDownCast(target)->SetLookupTable(numbers->GetLookupTable());
  }
  const int index = to->AddArray(target);
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    if (from->GetAbstractAttribute(attribute) == source)
    {
      to->SetActiveAttribute(index, attribute);
    }
  }
  return target;
}
}
