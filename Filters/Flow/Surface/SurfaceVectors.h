// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceVectors
 * @brief   the vectors of a mesh, along its triangles
 *
 * In a triangle the vectors of its corners are interpolated linearly and projected on its plane, or
 * it has its cell's vector. A vector is held as the rates of the three weights (barycentric
 * coordinates) of a place that moves along with it: their sum is 0, and no projection is left to be
 * made.
 *
 * Private to the module's own sources.
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

  /// `vectors` has three components and a tuple for every point or cell of `mesh`, whose points
  /// must stay.
  SurfaceVectors(vtkPolyData* mesh, vtkDataArray* vectors, bool isCellData, double noDataMagnitude);

  const SurfaceTriangles& GetTriangles() const { return this->Edges.GetTriangles(); }
  const SurfaceEdges& GetEdges() const { return this->Edges; }

  /// The length of the longest vector; 0 without any.
  double GetLongest() const { return this->Longest; }

  /// Whether there is no data, or no area to walk on.
  bool IsBlocked(int triangle) const { return this->Facets[triangle].Blocked; }

  /// The triangle beyond the edge that is opposite to a corner. -1 where the surface ends: at its
  /// border, where more than two triangles meet, and where the next one is blocked.
  int GetNeighbor(int triangle, int corner) const
  {
    return this->Facets[triangle].Neighbors[corner];
  }

  /// Relative to the longest vector.
  Weights GetRates(int triangle, const Weights& weights) const;

  /// The length of a vector, given as rates.
  double GetLength(int triangle, const Weights& rates) const;

  Vector GetPosition(int triangle, const Weights& weights) const;

  /// The weights of a place on the edge opposite to a corner in the triangle beyond, which there
  /// must be, and its corner `third` that is not on the edge.
  Weights GetNeighborWeights(int triangle, int corner, const Weights& weights, int& third) const;

  /// The distance of a corner from the opposite edge.
  double GetHeight(int triangle, int corner) const;

  /// Where on the opposite edge the height stands: 0 at its first end, 1 at its second.
  double GetFoot(int triangle, int corner) const;

private:
  struct Facet
  {
    double Rates[3][2]; // at each corner, of the second and the third weight
    double Metric[3];   // of the sides a, b from the first corner to the others: a.a, a.b, b.b
    int Neighbors[3];   // opposite to each corner
    bool Blocked;
  };

  const Vector& GetCorner(int triangle, int corner) const
  {
    return this->Points[this->GetTriangles().GetTriangles()[triangle][corner]];
  }
  /// The squared length of the edge opposite to a corner.
  double GetSquaredSide(int triangle, int corner) const;
  void FindLongest(vtkDataArray* vectors, double noDataMagnitude);
  void SetRates(int triangle, vtkDataArray* vectors, bool isCellData, double noDataMagnitude);
  void FindNeighbors();

  SurfaceEdges Edges;
  std::vector<Vector> Points;
  std::vector<Facet> Facets;
  double Longest = 0.0;
};

// Where most of the time of a streamline goes.
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
