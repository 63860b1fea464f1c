// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a mesh of a relief's pixels, for comparison
 */
#ifndef BenchmarkPixelMesh_h
#define BenchmarkPixelMesh_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkImageData;
class vtkPolyData;

/// A point for each valid texel, and two triangles between four texels with a connected surface.
vtkSmartPointer<vtkPolyData> MakePixelMesh(
  const std::vector<vtkSmartPointer<vtkImageData>>& reliefs);

/// Drawn with the captured colours, unlit.
vtkSmartPointer<vtkActor> MakePixelMeshActor(vtkPolyData* mesh);

#endif
