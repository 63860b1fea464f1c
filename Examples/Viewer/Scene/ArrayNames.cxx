// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkQuadratureSchemeDefinition.h"

#include <set>

namespace
{
// Excludes arrays that the program creates and those that make no sense as colours.
bool IsShown(vtkDataSetAttributes* data, vtkDataArray* array)
{
  const std::set<std::string> others = { vtkDataSetAttributes::GhostArrayName(),
    "vtkOriginalCellIds", "vtkOriginalPointIds", "PatchIds", "PatchCoordinates",
    "MicroMeshDirections", "MicroMeshFaces", "MicroMeshLevelErrors" };
  return array && array->GetName() && array != data->GetNormals() && array != data->GetTCoords() &&
    array != data->GetGlobalIds() && array != data->GetPedigreeIds() &&
    others.count(array->GetName()) == 0;
}

bool HasIntegrationPoints(vtkDataSet* mesh, vtkDataArray* ofCells)
{
  const int fewestPoints = 4; // cell arrays of fewer components are vectors
  vtkDataArray* field = mesh->GetFieldData()->GetArray(ofCells->GetName());
  const bool isAverage = field && field->HasInformation() &&
    field->GetInformation()->Has(vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME());
  return isAverage || ofCells->GetNumberOfComponents() >= fewestPoints;
}

std::string ListArrays(vtkDataSetAttributes* data, const std::string& association)
{
  std::string list;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (IsShown(data, array))
    {
      const int components = array->GetNumberOfComponents();
      list += (list.empty() ? "'" : ", '") + std::string(array->GetName()) + "' of " + association +
        (components > 1 ? " with " + std::to_string(components) + " components" : "");
    }
  }
  return list;
}
}

//------------------------------------------------------------------------------
std::string ListArrays(vtkPolyData* mesh)
{
  const std::string ofPoints = ListArrays(mesh->GetPointData(), "points");
  const std::string ofCells = ListArrays(mesh->GetCellData(), "cells");
  return ofPoints + (ofPoints.empty() || ofCells.empty() ? "" : ", ") + ofCells;
}

//------------------------------------------------------------------------------
std::vector<SceneArray> FindArrays(vtkDataSet* mesh)
{
  std::vector<SceneArray> arrays;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (IsShown(data, array))
      {
        const bool isOfPoints = data == mesh->GetPointData();
        arrays.push_back({ array->GetName(), isOfPoints, array->GetNumberOfComponents(),
          !isOfPoints && HasIntegrationPoints(mesh, array) });
      }
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
std::string GetArrayTitle(const std::string& name, int numberOfComponents)
{
  return numberOfComponents > 1 ? name + " (magnitude)" : name;
}
