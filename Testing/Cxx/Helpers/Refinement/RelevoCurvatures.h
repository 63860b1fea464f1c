// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of known curvature, and their values by vtkCurvatureDepthTagMetric.
#ifndef RelevoCurvatures_h
#define RelevoCurvatures_h

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <initializer_list>
#include <vector>

namespace RelevoCurvatures
{
using Mesh = vtkSmartPointer<vtkPolyData>;
const double Pi = vtkMath::Pi();

Mesh MakeMesh(std::initializer_list<std::vector<double>> coordinates,
  std::initializer_list<std::vector<vtkIdType>> polygons);

// A grid of columns x rows quads over [0, 1]^2. Closed meshes have duplicate points along their
// seams.
Mesh MakeGrid(
  int columns, int rows, const std::function<void(double u, double v, double x[3])>& map);

// Points along the seams are equal, bit for bit.
Mesh MakeTorus(double ringRadius, double radius, int columns, int rows);

Mesh MakeSphere(double radius, int subdivisions);

std::vector<double> Curvatures(vtkPolyData* mesh, int type);

std::vector<double> Gaussian(vtkPolyData* mesh);

std::vector<double> Mean(vtkPolyData* mesh);

double LargestError(
  const std::vector<double>& values, const std::function<double(size_t)>& expected);

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b);
}

#endif
