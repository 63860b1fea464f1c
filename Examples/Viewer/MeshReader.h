// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads the surface in a mesh file
 */
#ifndef MeshReader_h
#define MeshReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class ViewerMessages;

/// By the name: .vtp, .ply, .obj, .stl, .vtk or, where VTK reads them, .ex2.
bool IsMeshFile(const std::string& fileName);

/**
 * The polygons and strips of a file; of another data set than polygonal ones in a .vtk or .ex2 file
 * its outer surface. Throws ViewerError where there are none, or where a point is not finite.
 */
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& fileName, ViewerMessages& messages);

#endif
