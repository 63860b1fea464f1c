// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceField.h"

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

vtkIdType GetSize(vtkPolyData* mesh, bool ofCells)
{
  return ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
}

vtkDataSetAttributes* GetData(vtkPolyData* mesh, bool ofCells)
{
  return mesh->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
}
}

namespace relevo
{
SurfaceField FindSurfaceField(vtkPolyData* mesh, vtkInformation* wanted)
{
  const int association = wanted->Get(vtkDataObject::FIELD_ASSOCIATION());
  const char* name = wanted->Get(vtkDataObject::FIELD_NAME());
  const int attribute = wanted->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  std::ostringstream error;
  error << "has no array of 3 components";
  if (name)
  {
    error << " named \"" << name << '"';
  }
  for (bool ofCells : { false, true })
  {
    if (association ==
      (ofCells ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS))
    {
      continue;
    }
    vtkDataSetAttributes* data = GetData(mesh, ofCells);
    vtkDataArray* array = name ? data->GetArray(name) : data->GetAttribute(attribute);
    const vtkIdType size = GetSize(mesh, ofCells);
    if (CanBeVectors(array, size))
    {
      return { array, ofCells, "" };
    }
    if (array && name)
    {
      error << "; there are " << array->GetNumberOfTuples() << " tuples of "
            << array->GetNumberOfComponents() << " for " << size
            << (ofCells ? " cells" : " points");
    }
  }
  for (bool ofCells : { false, true })
  {
    vtkDataArray* array =
      name ? nullptr : FindFirst(GetData(mesh, ofCells), GetSize(mesh, ofCells));
    if (array)
    {
      return { array, ofCells, "" };
    }
  }
  return { nullptr, false, error.str() };
}
}
