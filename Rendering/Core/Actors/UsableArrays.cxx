// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Actors/UsableArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace relevo
{
namespace
{
std::string GetQuotedName(vtkAbstractArray* array)
{
  return std::string("\"") + (array->GetName() ? array->GetName() : "") + "\"";
}

void RemoveShortArrays(vtkDataSetAttributes* data, vtkIdType expected, std::string& text)
{
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < expected)
    {
      text += (text.empty() ? "Array " : " Array ") + GetQuotedName(array) +
        " has too few tuples and is left out.";
      data->RemoveArray(i);
    }
  }
}

void RemoveRoles(vtkDataSetAttributes* data)
{
  const struct
  {
    int Attribute;
    int Least;
    int Most;
  } roles[] = { { vtkDataSetAttributes::NORMALS, 3, 3 }, { vtkDataSetAttributes::TANGENTS, 3, 3 },
    { vtkDataSetAttributes::TCOORDS, 1, 3 } };
  for (const auto& role : roles)
  {
    vtkAbstractArray* array = data->GetAbstractAttribute(role.Attribute);
    if (array &&
      (array->GetNumberOfComponents() < role.Least || array->GetNumberOfComponents() > role.Most))
    {
      data->SetActiveAttribute(-1, role.Attribute);
    }
  }
}
}

std::string RemoveUnusableArrays(vtkPolyData* mesh)
{
  std::string text;
  RemoveShortArrays(mesh->GetPointData(), mesh->GetNumberOfPoints(), text);
  RemoveShortArrays(mesh->GetCellData(), mesh->GetNumberOfCells(), text);
  RemoveRoles(mesh->GetPointData());
  RemoveRoles(mesh->GetCellData());
  return text;
}

std::string FindMappingError(const ScalarMapping& mapping)
{
  vtkAbstractArray* scalars = mapping.Scalars;
  const bool isOfPoints = mapping.CellFlag == 0;
  const bool isOneTuple = mapping.CellFlag == 2 && mapping.FieldTuple >= 0;
  const vtkIdType tuples = scalars->GetNumberOfTuples();
  const vtkIdType needed = isOneTuple ? mapping.FieldTuple + 1
    : isOfPoints                      ? mapping.Input->GetNumberOfPoints()
                                      : mapping.Input->GetNumberOfCells();
  const std::string what = "Cannot colour by the array " + GetQuotedName(scalars) + ": it has ";
  if (tuples < needed && isOneTuple)
  {
    return what + "no value " + std::to_string(mapping.FieldTuple) + " (FieldDataTupleId).";
  }
  if (tuples < needed)
  {
    return what + "values for " + std::to_string(tuples) + " of " + std::to_string(needed) +
      (isOfPoints ? " points." : " cells.");
  }
  const bool isDirect = vtkDataArray::SafeDownCast(scalars) &&
    (mapping.ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
      (mapping.ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars)));
  const int components = scalars->GetNumberOfComponents();
  if (isDirect && (components < 1 || components > 4))
  {
    return what + std::to_string(components) +
      " components, but colours have 1 to 4. Map them by a lookup table "
      "(SetColorModeToMapScalars()).";
  }
  if (isDirect && vtkCharArray::SafeDownCast(scalars))
  {
    return what + "type char, but colours are unsigned char.";
  }
  return "";
}
}
