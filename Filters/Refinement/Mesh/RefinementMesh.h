// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementMesh
 * @brief   a coarse mesh prepared for refinement: faces, merged points, normals, precomputed
 * vectors
 *
 * It is built once per input, surface and displacement. Both evaluators read it. Polygons become
 * fans and strips become triangles, as in VTK's mapper. Triangles with coincident or non-finite
 * corners are dropped and counted. Triangles of patches (see PatchArrays) are dropped only if all
 * three corners coincide, because a patch can be larger than its corners.
 */
#ifndef RefinementMesh_h
#define RefinementMesh_h

#include "Mathematics/CornerOrder.h"       // for EdgeCorners
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkRefinementSurface.h"          // for Face
#include "vtkType.h"                       // for vtkIdType

#include <array>   // for members
#include <cstddef> // for size_t
#include <string>  // for errors
#include <vector>  // for members

class vtkDisplacement;
class vtkPolyData;

namespace relevo
{
struct GlobalSurfaceInfo;

/**
 * A coarse triangle. Its corners are sorted by merged point, so that the ends of an edge are in the
 * same order in all its faces.
 */
struct RefinementFace
{
  /// Point ids, sorted by merged point.
  int Corners[3];
  /// The input's cell.
  int Cell;
  /// Code of the permutation from the cell's order to the sorted order, see GetCornerOrder().
  unsigned char Order;
  /// If bit e is set, the edge (0: corners 0 1, 1: corners 1 2, 2: corners 0 2) is a diagonal of a
  /// polygon, which is hidden in wireframes.
  unsigned char HiddenEdges;

  /// Whether the sorted corners have the opposite winding of the cell.
  bool IsTurned() const { return (this->Order & 1) != 0; }
};

class RELEVOFILTERSREFINEMENT_EXPORT RefinementMesh
{
public:
  /**
   * Build the mesh for a surface and a displacement, both of which may be nullptr. Returns false
   * and sets GetError() if they cannot be applied. With `keepNormals`, Normals are also set if only
   * the input has them. `whole` is the surface that the mesh is a piece of.
   */
  bool Build(vtkPolyData* input, vtkRefinementSurface* surface, vtkDisplacement* displacement,
    bool keepNormals = false, const GlobalSurfaceInfo* whole = nullptr);

  const std::string& GetError() const { return this->Error; }

  /// Triangles that are dropped because corners coincide or a coordinate is not finite.
  vtkIdType GetNumberOfDroppedTriangles() const { return this->NumberOfDroppedTriangles; }

  /// The merged point of a point; see ComputeMergedPoints().
  int GetMergedPoint(int point) const
  {
    return this->MergedPoints.empty() ? point : static_cast<int>(this->MergedPoints[point]);
  }

  /// The coarse triangles, in the order of the input's polygons, then strips. Ghost cells are not
  /// included, but contribute to normals and frames.
  std::vector<RefinementFace> Faces;

  /// Lowest coincident point per point; empty if no points coincide.
  std::vector<vtkIdType> MergedPoints;

  /// Subtracted from the input's points before conversion to floats; 0 for float input.
  double Origin[3] = { 0.0, 0.0, 0.0 };

  /// 3 floats per point, relative to Origin.
  std::vector<float> Points;

  /// Unit shading normals, 3 floats per point; empty unless surface or displacement need them.
  std::vector<float> Normals;

  /// Unit normals per merged point, 3 floats per point, for displacement. Empty if displacement
  /// uses the surface's normals.
  std::vector<float> Directions;

  /// The surface's values per point, equal at coincident points; empty if there are none.
  std::vector<float> Values;
  int ValuesPerPoint = 0;
  const float* GetValues(int point) const
  {
    return this->Values.empty()
      ? nullptr
      : &this->Values[static_cast<std::size_t>(this->ValuesPerPoint) * point];
  }

  /// Texture coordinates, 2 floats per point; only with displacement.
  std::vector<float> TextureCoordinates;

  /// 8 floats per point: the surface gradients of the two texture coordinates, each padded to four.
  /// The fourth float is the mean curvature of the directions. Coincident points with the same
  /// texture coordinates and normals have the same values. Only with displacement.
  std::vector<float> Frames;

  /// The surface's vectors per face: edges (0,1), (1,2), (0,2), then those of the face; 3 floats
  /// each.
  std::vector<float> Vectors;
  int VectorsPerEdge = 0;
  int VectorsPerFace = 0;

  /// The surface's tables and the entry of each face; empty if there are none.
  vtkRefinementSurface::Tables Tables;
  std::vector<int> TableEntries;

  /// 9 point ids per face where the displacement samples heights on the face's border: the corners,
  /// then the first ends of the edges, then their second ends. Only with displacement and
  /// coincident points, so that a point on a seam has one height.
  std::vector<int> Seams;

  /// Edges between points: three per face, (0,1), (1,2), (0,2). Built on demand.
  void BuildEdges();
  std::vector<int> FaceEdges;
  int GetNumberOfEdges() const { return static_cast<int>(this->EdgeOwners.size()); }
  /// For each edge, its first position in FaceEdges.
  std::vector<int> EdgeOwners;

  /// The input of the surface's evaluation.
  vtkRefinementSurface::Face GetSurfaceFace(int face) const;

private:
  bool CheckCells(vtkPolyData* input);
  void BuildFaces(vtkPolyData* input);
  /// Drop triangles with coincident corners whose sides no other triangle has. Metrics ignore them.
  void DropLoneFaces();
  void RemoveGhosts(vtkPolyData* input);
  /// Whether the faces fit into floats. `isFlat` means that only corners are computed.
  bool CheckRange(vtkPolyData* input, bool isFlat);
  void BuildPoints(vtkPolyData* input, const GlobalSurfaceInfo* whole);
  void BuildNormals(vtkPolyData* input);
  void ComputeMissingNormals();
  void BuildDirections();
  bool BuildTextureCoordinates(vtkPolyData* input);
  void BuildFrames(bool alongNormal);
  /// For each point, the point whose frame it uses.
  std::vector<size_t> FindFramePoints() const;
  bool BuildValues(vtkPolyData* input, vtkRefinementSurface* surface);
  bool BuildTables(vtkPolyData* input, vtkRefinementSurface* surface);
  void BuildVectors(vtkRefinementSurface* surface);
  /// Whether two faces have different normals at a shared point.
  bool SplitsNormals(vtkRefinementSurface* surface) const;
  void BuildSeams();
  void BuildMergedEdges();

  std::string Error;
  vtkIdType NumberOfDroppedTriangles = 0;
  int NumberOfPoints = 0;

  /// Edges between merged points, for each face, and the distinct pairs of point ids per edge.
  std::vector<int> FaceMergedEdges;
  std::vector<int> MergedEdgeOffsets;
  std::vector<std::array<int, 2>> MergedEdgePairs;
};
}

#endif
