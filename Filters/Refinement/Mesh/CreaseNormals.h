// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CreaseNormals
 * @brief   a normal for each corner of a mesh's triangles, split where the mesh has creases
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
  /// Edges whose triangles meet at more than `featureAngle`, in radians, are creases, and so are
  /// edges of more than two triangles and of triangles that wind against each other. Triangles of
  /// one polygon have no crease between them. With `keepCoarseFlat`, normals of a coarse mesh,
  /// where most edges that bend do so by 2/3 to 3/2 of the feature angle, are those of its
  /// polygons, unless most corners have the mesh's own; and a noisy mesh has no creases by angle.
  CreaseNormals(vtkPolyData* mesh, double featureAngle, bool keepCoarseFlat);

  const SurfaceTriangles& GetTriangles() const { return *this->Triangles; }
  /// Edges that normals differ across, at both ends.
  vtkIdType GetNumberOfCreases() const { return this->NumberOfCreases; }
  /// Whether normals curve any face: at an end of an edge that bends they are the same on both
  /// sides, and the mesh is not noisy.
  bool AreCurved() const { return this->Curved; }
  /// The unit normal at a corner, at most the feature angle from that of its polygon there. Zero
  /// where the triangles around have no area.
  const dvec3& GetNormal(vtkIdType triangle, int corner) const
  {
    return this->Normals[3 * triangle + corner];
  }

private:
  /// Whether edges that bend by more than the feature angle are those of noise.
  bool AreCreasesNoise(const SurfaceEdges& edges, double featureAngle) const;
  /// Unites the corners of triangles that meet without a crease; returns whether most of the edges
  /// that bend may be creases or not.
  bool UniteCorners(
    const SurfaceEdges& edges, vtkIdType firstStrip, double featureAngle, DisjointSets& corners);
  /// Takes the mesh's own normals or the means of united corners; returns how many of the former.
  vtkIdType ChooseNormals(vtkPolyData* mesh, double featureAngle, DisjointSets& corners,
    const std::vector<dvec3>& polygons);
  /// For each corner the sum of the area vectors of its polygon's triangles there.
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
