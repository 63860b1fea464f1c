// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   dense meshes: scans of RELEVO_TEST_DATA and generated ones with fine relief
 */
#ifndef BenchmarkDenseMeshes_h
#define BenchmarkDenseMeshes_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace BenchmarkDenseMeshes
{
/// A file of the folder "mesh", without its extension, or a number of triangles of a sphere with
/// relief. The result has no arrays. It is nullptr if the file does not exist.
vtkSmartPointer<vtkPolyData> Make(const std::string& name);

/// Bytes of a mesh as a .vtp file, compressed by zlib.
double GetFileSize(vtkPolyData* mesh);

/// The largest distance of corners and centres of triangles to another mesh, in both directions.
double GetDistance(vtkPolyData* one, vtkPolyData* other);

/// The triangles of a micro-mesh.
vtkSmartPointer<vtkPolyData> Decode(vtkPolyData* micro, int level);

/// The mesh of vtkQuadricDecimation with the fewest triangles whose distance is not larger.
vtkSmartPointer<vtkPolyData> Decimate(vtkPolyData* dense, double distance);
}

#endif
