// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/LocationArrays.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace relevo
{
void AddLocationArrays(
  const double origin[3], const std::string& coordinateSystem, vtkDataObject* output)
{
  vtkNew<vtkDoubleArray> center;
  center->SetName("Origin");
  center->SetNumberOfComponents(3);
  center->InsertNextTuple(origin);
  vtkNew<vtkStringArray> system;
  system->SetName("CoordinateSystem");
  system->InsertNextValue(coordinateSystem);
  output->GetFieldData()->AddArray(center);
  output->GetFieldData()->AddArray(system);
}
}
