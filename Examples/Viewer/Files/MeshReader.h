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

/// By the name: an extension of a mesh's file, also where this VTK reads none of that kind.
bool IsMeshFile(const std::string& fileName);

/// What can be read, as ".ply, .stl or .vtp files".
std::string GetMeshFormats();

/// What is made of an unstructured grid.
enum class MeshCells
{
  Flat,   // its outer surface in flat polygons
  Curved, // if some cells are curved, their patches; else flat polygons
  Patches // patches, whatever its cells
};

/// A surface, and whether it is that of cells, which say themselves how they are curved.
struct SurfaceMesh
{
  vtkSmartPointer<vtkPolyData> Data;
  bool IsOfCells;
};

/**
 * The polygons and strips of a file; of another data set than polygonal ones in a .bpt, .vtk, .vtu,
 * .pvtu or .ex2 file its outer surface. Throws ViewerError where there are none, where a point is
 * not finite, or where a cell refers to a point that is not there.
 */
SurfaceMesh ReadMesh(const std::string& fileName, MeshCells cells, ViewerMessages& messages);

#endif
