// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that intersect, and results of their intersection.
#ifndef RelevoIntersections_h
#define RelevoIntersections_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

class vtkMatrix4x4;

// Polygons given by point indices. Points are doubles.
vtkSmartPointer<vtkPolyData> RelevoMakePolygons(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::vector<vtkIdType>>& cells);
// Six squares.
vtkSmartPointer<vtkPolyData> RelevoMakeBox(double low, double high);
// A closed mesh of triangles that share their points.
vtkSmartPointer<vtkPolyData> RelevoMakeSphere(
  int resolution, std::array<double, 3> center, double radius);

vtkSmartPointer<vtkMatrix4x4> RelevoMakeMotion(std::array<double, 3> translation, double degrees,
  std::array<double, 3> axis, double scale = 1.0);
// Transforms the points in double precision.
vtkSmartPointer<vtkPolyData> RelevoMove(vtkPolyData* mesh, vtkMatrix4x4* matrix);

double RelevoMeasureArea(vtkPolyData* mesh);
double RelevoMeasureLength(vtkPolyData* mesh);

// The pairs of cells in a mesh's arrays.
std::set<std::pair<vtkIdType, vtkIdType>> RelevoGetCellPairs(
  vtkPolyData* mesh, const char* first = "Input0CellID", const char* second = "Input1CellID");
// Whether points, cells and cell arrays are equal, bit for bit.
bool RelevoIsSameMesh(vtkPolyData* mesh, vtkPolyData* other);

#endif
