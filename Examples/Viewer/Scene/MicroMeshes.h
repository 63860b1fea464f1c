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
class vtkPolyData;
struct ViewerOptions;

/// Whether a mesh is the output of vtkMicroMeshFilter.
bool IsMicroMesh(vtkPolyData* mesh);

/// Encode a mesh within the tolerance of the options, and write it to the file of --micromesh.
/// Returns the micro-mesh, and lines about sizes and errors.
vtkSmartPointer<vtkPolyData> EncodeMicroMesh(
  const ViewerOptions& options, vtkPolyData* mesh, ViewerMessages& messages, std::string& report);

/// Return a line about the size and the error of a micro-mesh, in percent of a diagonal too.
std::string DescribeMicroMesh(vtkPolyData* micro, double diagonal);

#endif
