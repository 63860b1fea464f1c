// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RelevoUnevenNormals_h
#define RelevoUnevenNormals_h

#include "RelevoTestMeshes.h"

#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

namespace RelevoMeshes
{
// The mesh with normals of different lengths, some zero if `someAreZero`.
inline Mesh WithUnevenNormals(vtkPolyData* mesh, bool someAreZero)
{
  Mesh result = Make();
  result->ShallowCopy(mesh);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    // Direction and length change along a line, so the direction of a sum depends on the lengths.
    const double angle = 1.1 * static_cast<double>(i);
    const double length = someAreZero && i % 5 == 2 ? 0.0 : 0.1 + 0.8 * (i % 3);
    normals->InsertNextTuple3(length * std::sin(angle), 0.1 * length, length * std::cos(angle));
  }
  result->GetPointData()->SetNormals(normals);
  return result;
}
}

#endif
