// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes and images with vectors for the tests of vtkGeographicVectors.
#ifndef RelevoGeographicMesh_h
#define RelevoGeographicMesh_h

#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

// An array of doubles whose tuples have the same number of components.
vtkSmartPointer<vtkDoubleArray> RelevoMakeArray(
  const std::string& name, const std::vector<std::vector<double>>& tuples);

// Points without cells at z = 0, which vtkGeographicVectors accepts too.
vtkSmartPointer<vtkPolyData> RelevoMakePoints(const std::vector<std::array<double, 2>>& places);

std::array<double, 3> RelevoVectorOf(vtkPolyData* mesh, vtkIdType point, const char* name);

#endif
