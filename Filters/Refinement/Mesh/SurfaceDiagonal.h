// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceDiagonal
 * @brief   how large a mesh is, as it is drawn
 *
 * Not wrapped: for the modules' own sources.
 */
#ifndef SurfaceDiagonal_h
#define SurfaceDiagonal_h

#include "Mesh/SurfaceTriangles.h" // for members

class vtkPolyData;

#ifndef __VTK_WRAP__
namespace relevo
{
struct Placement;

class SurfaceDiagonal
{
public:
  /// The diagonal of the bounding box of the mesh's triangles, in the world's units: see
  /// Placement::GetDiagonal(). Points that no triangle uses do not count, unless there is none.
  double Get(vtkPolyData* mesh, const Placement& placement);

private:
  void Compute(vtkPolyData* mesh);

  GeometryStamp Of{};
  bool HasTriangles = false;
  double Sides[3] = { 0.0, 0.0, 0.0 };
};
}
#endif

#endif
