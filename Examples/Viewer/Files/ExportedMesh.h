// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ExportedMesh
 * @brief   a mesh to be written to a file, with its picture and its place in the world
 */
#ifndef ExportedMesh_h
#define ExportedMesh_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

struct ExportedMesh
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkImageData> Picture; // in its texture coordinates; nullptr without one
  int UpAxis = 1;                        // 0 for x, 1 for y, 2 for z
  std::array<double, 3> Origin{ { 0.0, 0.0, 0.0 } }; // of files with floats, in coordinates of Mesh
  std::vector<std::string> Comments;                 // for formats that have comments
};

#endif
