// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of points that tests give their meshes: depth-tags, texture coordinates, vectors, scalar
// tags, other normals.
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

// A tuple of `vectors` for every point, by its place.
void FillVectors(vtkPolyData* mesh,
  const std::function<std::array<double, 3>(const std::array<double, 3>&)>& function,
  vtkDataArray* vectors);

// Texture coordinates in [0, 1]^2 that have nothing to do with each other: every point its chart.
void AddRandomTextureCoordinates(vtkPolyData* mesh, unsigned int seed);

// The mesh with such coordinates.
Mesh Textured(Mesh mesh);

// An array for vtkScalarTaggedSurface, all zero.
vtkSmartPointer<vtkFloatArray> AddScalarTags(
  vtkPolyData* mesh, const char* name, int components = 1);

// Tags of any kind at two points in three, some beyond their range; half of the sharp ones have a
// direction.
void AddRandomScalarTags(vtkPolyData* mesh, unsigned int seed);

// Unit normals in the outer half space of the given ones, or of the faces.
void PerturbNormals(vtkPolyData* mesh, unsigned int seed, double amount);
}

#endif
