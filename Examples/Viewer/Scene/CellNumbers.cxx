// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/CellNumbers.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <limits>

namespace
{
std::string DescribeNumber(
  vtkDataArray* globalIds, vtkIdType id, const std::string& counted, const std::string& named)
{
  return globalIds
    ? named + " " + std::to_string(static_cast<vtkIdType>(globalIds->GetComponent(id, 0)))
    : counted + " " + std::to_string(id);
}
}

//------------------------------------------------------------------------------
std::string DescribeCell(vtkDataSet* mesh, vtkIdType cell, const double place[3])
{
  vtkNew<vtkIdList> points;
  mesh->GetCellPoints(cell, points);
  vtkIdType nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    double point[3];
    mesh->GetPoint(points->GetId(i), point);
    const double distance = vtkMath::Distance2BetweenPoints(point, place);
    if (distance < least)
    {
      least = distance;
      nearest = points->GetId(i);
    }
  }
  const std::string text =
    DescribeNumber(mesh->GetCellData()->GetGlobalIds(), cell, "cell", "element");
  return nearest < 0
    ? text
    : text + "  " + DescribeNumber(mesh->GetPointData()->GetGlobalIds(), nearest, "point", "node");
}
