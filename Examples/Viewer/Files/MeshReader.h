// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads the surface of a mesh file
 */
#ifndef MeshReader_h
#define MeshReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class ViewerMessages;

/// Whether the name has the extension of a mesh format, even if this version of VTK cannot read it.
bool IsMeshFile(const std::string& fileName);

/// The supported formats, as in ".ply, .stl or .vtp files".
std::string GetMeshFormats();

/// Advice, as the end of a sentence, for a file that is not a mesh by its extension: the formats of
/// meshes, or "" if the extension is that of a raster.
std::string AdviseFormat(const std::string& fileName, const std::string& formats);

/// The surface of an unstructured grid.
enum class MeshCells
{
  Flat,   // the outer surface in flat polygons
  Curved, // patches if some cells are curved, otherwise flat polygons
  Patches // patches for all cells
};

/// A surface, and whether it comes from cells, which define their curvature.
struct SurfaceMesh
{
  vtkSmartPointer<vtkPolyData> Data;
  bool IsOfCells;
};

/**
 * Reads the polygons and strips of a file. For other data sets in a .bpt, .vtk, .vtu, .pvtu or .ex2
 * file, returns the outer surface. Throws ViewerError if there are none, if a point is not finite,
 * or if a cell refers to a missing point.
 */
SurfaceMesh ReadMesh(const std::string& fileName, MeshCells cells, ViewerMessages& messages);

#endif
