// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   tables of micro-meshes for relevoMicroMesh.glsl
 */
#ifndef MicroMeshTables_h
#define MicroMeshTables_h

#include "Mesh/FaceCorners.h"
#include "vtkRefinementSurface.h"

#include "vtkSmartPointer.h"

class vtkDataArray;

namespace relevo
{
/// A face of a micro-mesh, evaluated in C++.
struct MicroMeshFace : FaceCorners<vtkRefinementSurface::Face>
{
  explicit MicroMeshFace(const vtkRefinementSurface::Face& face)
    : FaceCorners<vtkRefinementSurface::Face>{ face, 0 }
  {
  }

  vec4 cornerValues(int i) const { return vec4(Load(this->Face.Values[i]), 0.0f); }

// The others use it.
#include "glsl/relevoMicroTriangle.glsl"

#include "glsl/relevoMicroCells.glsl"
#include "glsl/relevoMicroField.glsl"
#include "glsl/relevoMicroMesh.glsl"

  /// The lowest and highest displacement, 0 included.
  ivec2 GetRange() const
  {
    const ivec4 record = this->tableRecord(this->tableEntry() + 1);
    return ivec2(record.z, record.w);
  }
};

/// The values of a point array at all grid points, or nullptr if the mesh has none that fit.
vtkDataArray* FindMicroPointData(vtkPolyData* mesh, vtkDataArray* pointArray);

/// Interpolate these values on the triangles of a face's grid. The weights are those of the sorted
/// corners.
void EvaluateMicroPointData(const vtkRefinementSurface::Face& face, const float weights[3],
  vtkDataArray* values, double* tuple);

/// The values of a cell array on all triangles of grids, 2 per grid point, or nullptr if the mesh
/// has none that fit.
vtkSmartPointer<vtkDataArray> FindMicroCellData(vtkPolyData* mesh, vtkDataArray* cellArray);

/// The tuple of these values for the weights of the sorted corners.
vtkIdType FindMicroCellTuple(const vtkRefinementSurface::Face& face, const float weights[3]);

/// See vtkRefinementSurface::BuildTables().
bool BuildMicroMeshTables(
  vtkPolyData* mesh, vtkRefinementSurface::Tables& tables, std::string& error);
}

#endif
