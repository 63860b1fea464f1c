// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the rival of a relief: a mesh of its pixels
 */
#ifndef BenchmarkPixelMesh_h
#define BenchmarkPixelMesh_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkImageData;
class vtkPolyData;

/// A point for each valid texel, two triangles wherever the relief has a surface between four.
vtkSmartPointer<vtkPolyData> MakePixelMesh(
  const std::vector<vtkSmartPointer<vtkImageData>>& reliefs);

/// Drawn as captured: colours without light.
vtkSmartPointer<vtkActor> MakePixelMeshActor(vtkPolyData* mesh);

#endif
