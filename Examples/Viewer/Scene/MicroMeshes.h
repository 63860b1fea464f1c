// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   dense meshes as coarse meshes with displacements
 */
#ifndef MicroMeshes_h
#define MicroMeshes_h

#include "vtkSmartPointer.h"

#include <string>

class ViewerMessages;
class vtkDataSet;
class vtkPolyData;
struct ViewerOptions;

/// Whether a mesh is the output of vtkMicroMeshFilter.
bool IsMicroMesh(vtkPolyData* mesh);

/// The surface of a mesh, or a data set with solid cells that contains it.
struct DenseSurface
{
  vtkPolyData* Mesh;
  vtkDataSet* Cells;
  std::string Array; // of --array, or ""
};

/// Encode a surface, or isosurfaces of its cells, within the tolerance of the options, and write it
/// to a file. Returns the micro-mesh, and lines about sizes and errors.
vtkSmartPointer<vtkPolyData> EncodeMicroMesh(const ViewerOptions& options,
  const DenseSurface& surface, const std::string& file, ViewerMessages& messages,
  std::string& report);

/// Return a line about the size and the error of a micro-mesh, in percent of the diagonal of its
/// input too.
std::string DescribeMicroMesh(vtkPolyData* micro);

#endif
