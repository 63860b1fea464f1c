// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/SameData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace
{
bool AreSameArrays(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a == b)
  {
    return a == b;
  }
  const bool isAlike = a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples();
  return isAlike &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

std::string GetName(vtkDataArray* array)
{
  return array && array->GetName() ? array->GetName() : "";
}

bool AreSameAttributes(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = a->GetArray(i);
    if (array && !AreSameArrays(array, b->GetArray(GetName(array).c_str())))
    {
      return false;
    }
  }
  return GetName(a->GetScalars()) == GetName(b->GetScalars()) &&
    GetName(a->GetNormals()) == GetName(b->GetNormals()) &&
    GetName(a->GetTCoords()) == GetName(b->GetTCoords());
}

// The points and cells of images follow from these numbers.
bool AreSameImages(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent()) &&
    std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing());
}

bool AreSamePoints(vtkDataSet* a, vtkDataSet* b)
{
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    if (!std::equal(p, p + 3, q))
    {
      return false;
    }
  }
  return true;
}

bool AreSameCells(vtkDataSet* a, vtkDataSet* b)
{
  vtkNew<vtkIdList> p;
  vtkNew<vtkIdList> q;
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    a->GetCellPoints(cell, p);
    b->GetCellPoints(cell, q);
    if (a->GetCellType(cell) != b->GetCellType(cell) ||
      p->GetNumberOfIds() != q->GetNumberOfIds() || !std::equal(p->begin(), p->end(), q->begin()))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool AreSameData(vtkDataObject* first, vtkDataObject* second)
{
  auto* a = vtkDataSet::SafeDownCast(first);
  auto* b = vtkDataSet::SafeDownCast(second);
  if (!a || !b || std::string(a->GetClassName()) != b->GetClassName() ||
    a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return false;
  }
  auto* pointsOfA = vtkPointSet::SafeDownCast(a);
  auto* pointsOfB = vtkPointSet::SafeDownCast(b);
  const bool isOneType = !pointsOfA || !pointsOfA->GetPoints() || !pointsOfB->GetPoints() ||
    pointsOfA->GetPoints()->GetDataType() == pointsOfB->GetPoints()->GetDataType();
  auto* imageOfA = vtkImageData::SafeDownCast(a);
  const bool isOneShape = imageOfA ? AreSameImages(imageOfA, vtkImageData::SafeDownCast(b))
                                   : isOneType && AreSamePoints(a, b) && AreSameCells(a, b);
  return isOneShape && AreSameAttributes(a->GetPointData(), b->GetPointData()) &&
    AreSameAttributes(a->GetCellData(), b->GetCellData());
}
