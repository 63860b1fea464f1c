// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CreaseNormals
 * @brief   a normal for each corner of a mesh's triangles, split at creases
 */
#ifndef CreaseNormals_h
#define CreaseNormals_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceTriangles.h"

#include <memory> // for members
#include <vector> // for members

class vtkPolyData;

namespace relevo
{
class DisjointSets;
class SurfaceEdges;

class CreaseNormals
{
public:
  /// Edges whose triangles meet at more than `featureAngle`, in radians, are creases. Edges of more
  /// than two triangles, and of triangles with opposite winding, are creases too. Triangles of one
  /// polygon have no crease between them. With `keepCoarseFlat`, a coarse mesh, where most bent
  /// edges bend by 2/3 to 3/2 of the feature angle, gets the normals of its polygons, unless most
  /// corners use the mesh's normals. A noisy mesh then has no creases by angle.
  CreaseNormals(vtkPolyData* mesh, double featureAngle, bool keepCoarseFlat);

  const SurfaceTriangles& GetTriangles() const { return *this->Triangles; }
  /// The number of edges whose normals differ on both sides, at both ends.
  vtkIdType GetNumberOfCreases() const { return this->NumberOfCreases; }
  /// Whether a face is curved: at an end of a bent edge, the normals on both sides are equal, and
  /// the mesh is not noisy.
  bool AreCurved() const { return this->Curved; }
  /// The unit normal at a corner. It differs from the polygon's normal by at most the feature
  /// angle. It is 0 if the triangles have no area.
  const dvec3& GetNormal(vtkIdType triangle, int corner) const
  {
    return this->Normals[3 * triangle + corner];
  }

private:
  /// Whether the edges that bend by more than the feature angle are noise.
  bool AreCreasesNoise(const SurfaceEdges& edges, double featureAngle) const;
  /// Unite the corners of triangles that meet without a crease. Returns whether most of the bent
  /// edges are ambiguous.
  bool UniteCorners(
    const SurfaceEdges& edges, vtkIdType firstStrip, double featureAngle, DisjointSets& corners);
  /// Choose the mesh's normals or the means of united corners. Returns the number of mesh normals.
  vtkIdType ChooseNormals(vtkPolyData* mesh, double featureAngle, DisjointSets& corners,
    const std::vector<dvec3>& polygons);
  /// For each corner, the sum of the area vectors of its polygon's triangles there.
  std::vector<dvec3> SumPolygons(vtkIdType firstStrip) const;
  void CountCreases(const SurfaceEdges& edges);
  vtkIdType FindCorner(vtkIdType triangle, vtkIdType mergedPoint) const;

  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::vector<dvec3> AreaVectors;
  std::vector<dvec3> Normals;
  vtkIdType NumberOfCreases = 0;
  bool Curved = false;
};
}

#endif
