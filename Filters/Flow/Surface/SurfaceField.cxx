// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceField.h"

#include "Checks/MisplacedArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <sstream>

namespace
{
bool CanBeVectors(vtkDataArray* array, vtkIdType numberOfTuples)
{
  return array && array->GetNumberOfComponents() == 3 &&
    array->GetNumberOfTuples() == numberOfTuples;
}

vtkDataArray* FindFirst(vtkDataSetAttributes* data, vtkIdType numberOfTuples)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (CanBeVectors(array, numberOfTuples) && array != data->GetNormals() &&
      array != data->GetTCoords())
    {
      return array;
    }
  }
  return nullptr;
}

vtkIdType GetSize(vtkPolyData* mesh, bool isCellData)
{
  return isCellData ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
}

vtkDataSetAttributes* GetData(vtkPolyData* mesh, bool isCellData)
{
  return mesh->GetAttributes(isCellData ? vtkDataObject::CELL : vtkDataObject::POINT);
}
}

namespace relevo
{
SurfaceField FindSurfaceField(vtkPolyData* mesh, vtkInformation* inputArray)
{
  const int association = inputArray->Get(vtkDataObject::FIELD_ASSOCIATION());
  const char* name = inputArray->Get(vtkDataObject::FIELD_NAME());
  const int attribute = inputArray->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  std::ostringstream error;
  error << "has no array of 3 components";
  if (name)
  {
    error << " named \"" << name << '"';
  }
  for (bool isCellData : { false, true })
  {
    if (association ==
      (isCellData ? vtkDataObject::FIELD_ASSOCIATION_POINTS
                  : vtkDataObject::FIELD_ASSOCIATION_CELLS))
    {
      continue;
    }
    vtkDataSetAttributes* data = GetData(mesh, isCellData);
    vtkDataArray* array = name ? data->GetArray(name) : data->GetAttribute(attribute);
    const vtkIdType size = GetSize(mesh, isCellData);
    if (CanBeVectors(array, size))
    {
      return { array, isCellData, "" };
    }
    if (array && name)
    {
      error << "; the " << (isCellData ? "cell" : "point") << " array has "
            << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
            << " for " << size << (isCellData ? " cells" : " points");
    }
  }
  for (bool isCellData : { false, true })
  {
    vtkDataArray* array =
      name ? nullptr : FindFirst(GetData(mesh, isCellData), GetSize(mesh, isCellData));
    if (array)
    {
      return { array, isCellData, "" };
    }
  }
  const std::string misplaced =
    name ? DescribeMisplacedArray(mesh, name, association, AdviseInputArray(name)) : "";
  return { nullptr, false, misplaced.empty() ? error.str() : "has " + misplaced };
}
}
