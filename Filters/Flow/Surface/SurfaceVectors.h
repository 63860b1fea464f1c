// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceVectors
 * @brief   vectors on the triangles of a mesh
 *
 * Point vectors are interpolated linearly and projected to the plane of the triangle. Cell vectors
 * are projected. A vector is stored as the rates of change of the three barycentric coordinates
 * (weights) of a point that moves with it. Their sum is 0, and no further projection is necessary.
 *
 * Private to the module.
 */
#ifndef SurfaceVectors_h
#define SurfaceVectors_h

#include "Mesh/SurfaceEdges.h"       // for members
#include "RelevoFiltersFlowModule.h" // for export macro

#include <algorithm> // for max
#include <array>     // for members
#include <cmath>     // for sqrt
#include <vector>    // for members

class vtkDataArray;
class vtkPolyData;

namespace relevo
{
class RELEVOFILTERSFLOW_EXPORT SurfaceVectors
{
public:
  using Weights = std::array<double, 3>;
  using Vector = std::array<double, 3>;

  /// `vectors` has three components and a tuple for each point or cell. The points of `mesh` must
  /// not change.
  SurfaceVectors(vtkPolyData* mesh, vtkDataArray* vectors, bool isCellData, double noDataMagnitude);

  const SurfaceTriangles& GetTriangles() const { return this->Edges.GetTriangles(); }
  const SurfaceEdges& GetEdges() const { return this->Edges; }

  /// Returns the length of the longest vector, or 0.
  double GetLongest() const { return this->Longest; }

  /// Whether data is missing at a corner, or the triangle has no area.
  bool IsBlocked(int triangle) const { return this->Facets[triangle].Blocked; }

  /// Returns the triangle across the edge opposite to a corner. It is -1 at the border of the
  /// surface, at edges of more than two triangles, and if that triangle is blocked.
  int GetNeighbor(int triangle, int corner) const
  {
    return this->Facets[triangle].Neighbors[corner];
  }

  /// Returns rates relative to the length of the longest vector.
  Weights GetRates(int triangle, const Weights& weights) const;

  /// Returns the length of a vector given by rates.
  double GetLength(int triangle, const Weights& rates) const;

  Vector GetPosition(int triangle, const Weights& weights) const;

  /// Converts the weights of a point on the edge opposite to a corner to weights in the triangle
  /// across that edge, which must exist. `third` returns the corner of that triangle that is not on
  /// the edge.
  Weights GetNeighborWeights(int triangle, int corner, const Weights& weights, int& third) const;

  /// Returns the distance of a corner from the opposite edge.
  double GetHeight(int triangle, int corner) const;

  /// Returns the position of the perpendicular foot of a corner on the opposite edge: 0 at the
  /// first end, 1 at the second.
  double GetFoot(int triangle, int corner) const;

private:
  struct Facet
  {
    double Rates[3][2]; // at each corner, of the second and the third weight
    double Metric[3];   // dot products a.a, a.b, b.b of the sides a, b from the first corner
    int Neighbors[3];   // opposite to each corner
    bool Blocked;
  };

  const Vector& GetCorner(int triangle, int corner) const
  {
    return this->Points[this->GetTriangles().GetTriangles()[triangle][corner]];
  }
  /// Returns the squared length of the edge opposite to a corner.
  double GetSquaredSide(int triangle, int corner) const;
  void FindLongest(vtkDataArray* vectors, double noDataMagnitude);
  void SetRates(int triangle, vtkDataArray* vectors, bool isCellData, double noDataMagnitude);
  void FindNeighbors();

  SurfaceEdges Edges;
  std::vector<Vector> Points;
  std::vector<Facet> Facets;
  double Longest = 0.0;
};

// Inline because streamlines spend most of their time here.
inline SurfaceVectors::Weights SurfaceVectors::GetRates(int triangle, const Weights& weights) const
{
  const Facet& facet = this->Facets[triangle];
  double rates[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < 3; ++corner)
  {
    rates[0] += weights[corner] * facet.Rates[corner][0];
    rates[1] += weights[corner] * facet.Rates[corner][1];
  }
  return { -rates[0] - rates[1], rates[0], rates[1] };
}

inline double SurfaceVectors::GetLength(int triangle, const Weights& rates) const
{
  const double* metric = this->Facets[triangle].Metric;
  const double squared = rates[1] * rates[1] * metric[0] + 2.0 * rates[1] * rates[2] * metric[1] +
    rates[2] * rates[2] * metric[2];
  return std::sqrt(std::max(squared, 0.0));
}
}

#endif
