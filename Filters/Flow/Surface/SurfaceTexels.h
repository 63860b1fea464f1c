// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceTexels
 * @brief   positions of texels on a surface
 *
 * Private to the module.
 */
#ifndef SurfaceTexels_h
#define SurfaceTexels_h

#include "vtkType.h" // for vtkIdType

#include <array>
#include <vector>

class vtkDataArray;

namespace relevo
{
class SurfaceTriangles;

class SurfaceTexels
{
public:
  using Weights = std::array<double, 3>;

  /// Texel centres are at (i + 1/2) / size in texture coordinates, which have at least two
  /// components. Where triangles overlap, the first one gets the texel.
  SurfaceTexels(const int size[2], const SurfaceTriangles& surface, vtkDataArray* coordinates);

  vtkIdType GetNumberOfTexels() const { return static_cast<vtkIdType>(this->Triangles.size()); }
  vtkIdType GetNumberOfCoveredTexels() const { return this->NumberOfCoveredTexels; }

  /// Returns the triangle at the centre of a texel, or -1.
  int GetTriangle(vtkIdType texel) const { return this->Triangles[texel]; }

  /// Returns the barycentric coordinates of the centre of a covered texel.
  Weights GetWeights(vtkIdType texel) const;

  /// Returns for each texel a covered texel nearby, which is approximately the nearest: each texel
  /// compares the nearest texels of its neighbours.
  std::vector<vtkIdType> FindNearestCovered() const;

private:
  struct Corners
  {
    double X[3];
    double Y[3];
  };

  bool GetCorners(int triangle, Corners& corners) const;
  void Cover(int triangle);

  int Size[2];
  const SurfaceTriangles& Surface;
  vtkDataArray* Coordinates;
  std::vector<int> Triangles;
  vtkIdType NumberOfCoveredTexels = 0;
};
}

#endif
