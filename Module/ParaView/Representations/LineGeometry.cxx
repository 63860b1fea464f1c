// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LineGeometry.h"

#include "Composite/DataLeaves.h"
#include "CurveLines.h"
#include "LeafConversion.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace relevo
{
vtkStandardNewMacro(LineGeometry);

LineGeometry::LineGeometry() = default;

LineGeometry::~LineGeometry() = default;

int LineGeometry::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto convert = [](const DataLeaf& leaf) -> vtkSmartPointer<vtkDataObject>
  {
    if (auto grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data))
    {
      return MakeCurveLines(grid);
    }
    auto mesh = vtkPolyData::SafeDownCast(leaf.Data);
    return mesh ? MakeCurveLines(mesh) : vtkSmartPointer<vtkPolyData>::New();
  };
  return RequestConverted(inputVector, outputVector, convert,
    [&](vtkInformationVector** inputs)
    { return this->Superclass::RequestData(request, inputs, outputVector); });
}
}
