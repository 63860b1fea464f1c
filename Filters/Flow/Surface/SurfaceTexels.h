// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceTexels
 * @brief   where the texels of a texture lie on a surface
 *
 * Private to the module's own sources.
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

  /// The centres of texels lie at (i + 1/2) / size of the texture coordinates, which have at least
  /// two components. Where triangles overlap, the first has the texel.
  SurfaceTexels(const int size[2], const SurfaceTriangles& surface, vtkDataArray* coordinates);

  vtkIdType GetNumberOfTexels() const { return static_cast<vtkIdType>(this->Triangles.size()); }
  vtkIdType GetNumberOfCoveredTexels() const { return this->NumberOfCoveredTexels; }

  /// The triangle at a texel's centre; -1 without.
  int GetTriangle(vtkIdType texel) const { return this->Triangles[texel]; }

  /// Where in its triangle the centre of a covered texel lies.
  Weights GetWeights(vtkIdType texel) const;

  /// For every texel one that is covered, and near: itself, or by way of neighbours' nearest.
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
