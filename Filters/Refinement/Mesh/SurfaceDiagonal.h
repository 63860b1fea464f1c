// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceDiagonal
 * @brief   how large a mesh is, as it is drawn
 */
#ifndef SurfaceDiagonal_h
#define SurfaceDiagonal_h

class vtkPolyData;

namespace relevo
{
struct Placement;
class SurfaceTriangles;

class SurfaceDiagonal
{
public:
  SurfaceDiagonal(vtkPolyData* mesh, const SurfaceTriangles& surface);

  /// The diagonal of the bounding box of the mesh's triangles, in the world's units: see
  /// Placement::GetDiagonal(). Points that no triangle uses do not count, unless there is none.
  double Get(const Placement& placement) const;

private:
  double Sides[3] = { 0.0, 0.0, 0.0 };
};
}

#endif
