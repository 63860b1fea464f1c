// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Point arrays for test meshes: depth-tags, texture coordinates, vectors, scalar tags and modified
// normals.
#ifndef RelevoMeshArrays_h
#define RelevoMeshArrays_h

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>

namespace RelevoMeshes
{
using Mesh = vtkSmartPointer<vtkPolyData>;

void AddTags(vtkPolyData* mesh, unsigned int seed, int maximum);

Mesh Tagged(Mesh mesh, int level);

void AddTextureCoordinates(
  vtkPolyData* mesh, const std::function<std::array<double, 2>(const double*)>& function);

// Fills `vectors` with a tuple for every point, by its position.
void FillVectors(vtkPolyData* mesh,
  const std::function<std::array<double, 3>(const std::array<double, 3>&)>& function,
  vtkDataArray* vectors);

// Independent random texture coordinates in [0, 1]^2 for every point.
void AddRandomTextureCoordinates(vtkPolyData* mesh, unsigned int seed);

// The mesh with independent random texture coordinates.
Mesh Textured(Mesh mesh);

// An array for vtkScalarTaggedSurface, all zero.
vtkSmartPointer<vtkFloatArray> AddScalarTags(
  vtkPolyData* mesh, const char* name, int components = 1);

// Random tags for two of three points, some out of range. Half of the sharp points have a
// direction.
void AddRandomScalarTags(vtkPolyData* mesh, unsigned int seed);

// Unit normals in the half space of the existing normals or of the faces' normals.
void PerturbNormals(vtkPolyData* mesh, unsigned int seed, double amount);
}

#endif
