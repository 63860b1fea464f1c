// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementMesh
 * @brief   a coarse mesh made ready for refinement: faces, places, normals, precomputed vectors
 *
 * Built once per input, surface and displacement, and read by both evaluators. Polygons become fans
 * and strips become triangles, as VTK's own mapper draws them. Triangles with two corners at one
 * place or with non-finite coordinates are dropped and counted; but parts of patches (see
 * PatchArrays) only if all three are at one place, for the patch can be more than its corners.
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
 * A coarse triangle. Its corners are sorted by place, so that an edge's two ends come in the same
 * order in every face that shares it.
 */
struct RefinementFace
{
  /// Point ids, sorted by place.
  int Corners[3];
  /// The input's cell.
  int Cell;
  /// Code of the permutation from the cell's own order to the sorted one, see GetCornerOrder().
  unsigned char Order;
  /// Bit e set: the edge (0: corners 0 1, 1: corners 1 2, 2: corners 0 2) is not an edge of the
  /// cell but the diagonal of a polygon, to be hidden in wireframes.
  unsigned char HiddenEdges;

  /// Whether the sorted corners run against the cell's own sense.
  bool IsTurned() const { return (this->Order & 1) != 0; }
};

class RELEVOFILTERSREFINEMENT_EXPORT RefinementMesh
{
public:
  /**
   * Take a mesh and what a surface and a displacement, both of which may be nullptr, ask for.
   * Returns false and sets GetError() when they cannot be applied to it. With `keepNormals`,
   * Normals are filled also where only the input has them. `whole` is what the mesh is a piece of.
   */
  bool Build(vtkPolyData* input, vtkRefinementSurface* surface, vtkDisplacement* displacement,
    bool keepNormals = false, const GlobalSurfaceInfo* whole = nullptr);

  const std::string& GetError() const { return this->Error; }

  /// Triangles left out because two corners coincide or a coordinate is not finite.
  vtkIdType GetNumberOfDroppedTriangles() const { return this->NumberOfDroppedTriangles; }

  /// The point's place; see ComputeMergedPoints().
  int GetMergedPoint(int point) const
  {
    return this->MergedPoints.empty() ? point : static_cast<int>(this->MergedPoints[point]);
  }

  /// The coarse triangles, in the order of the input's polygons, then strips; without ghosts, which
  /// count for normals and frames all the same.
  std::vector<RefinementFace> Faces;

  /// Lowest coincident point per point; empty when none coincide.
  std::vector<vtkIdType> MergedPoints;

  /// Subtracted from the input's points before they become floats; zero for float input.
  double Origin[3] = { 0.0, 0.0, 0.0 };

  /// 3 floats per point, relative to Origin.
  std::vector<float> Points;

  /// Unit shading normals, 3 floats per point; empty unless surface or displacement need them.
  std::vector<float> Normals;

  /// Unit normals per place, 3 floats per point, which displacement goes along; empty when it goes
  /// along the surface's own normals.
  std::vector<float> Directions;

  /// The surface's numbers per point, the same at all points of a place; empty without.
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

  /// Per point 8 floats: the surface gradients of the two texture coordinates, each padded to
  /// four; the fourth of the first is the mean curvature of the directions. Coincident points with
  /// the same texture coordinates and normals have the same ones. Only with displacement.
  std::vector<float> Frames;

  /// The surface's vectors per face: edges (0,1), (1,2), (0,2), then the face's own; 3 floats each.
  std::vector<float> Vectors;
  int VectorsPerEdge = 0;
  int VectorsPerFace = 0;

  /// The surface's tables, and for each face its entry; empty without.
  vtkRefinementSurface::Tables Tables;
  std::vector<int> TableEntries;

  /// Per face 9 point ids that the displacement samples at the face's border: the corners', then
  /// for each edge its first ends', then its second ends'. Only with displacement and coincident
  /// points: a seam point has one height.
  std::vector<int> Seams;

  /// Edges between points: for each face its three (0,1), (1,2), (0,2). Built on demand.
  void BuildEdges();
  std::vector<int> FaceEdges;
  int GetNumberOfEdges() const { return static_cast<int>(this->EdgeOwners.size()); }
  /// For each edge the first of its places in FaceEdges.
  std::vector<int> EdgeOwners;

  /// What a surface is evaluated from.
  vtkRefinementSurface::Face GetSurfaceFace(int face) const;

private:
  bool CheckCells(vtkPolyData* input);
  void BuildFaces(vtkPolyData* input);
  /// Drop triangles with two corners at one place whose sides no other triangle has: metrics know
  /// nothing of them.
  void DropLoneFaces();
  void RemoveGhosts(vtkPolyData* input);
  /// Whether floats have room for the faces; `isFlat` tells that corners are all that is computed.
  bool CheckRange(vtkPolyData* input, bool isFlat);
  void BuildPoints(vtkPolyData* input, const GlobalSurfaceInfo* whole);
  void BuildNormals(vtkPolyData* input);
  void ComputeMissingNormals();
  void BuildDirections();
  bool BuildTextureCoordinates(vtkPolyData* input);
  void BuildFrames(bool alongNormal);
  /// For each point the one whose frame it has.
  std::vector<size_t> FindFramePoints() const;
  bool BuildValues(vtkPolyData* input, vtkRefinementSurface* surface);
  bool BuildTables(vtkPolyData* input, vtkRefinementSurface* surface);
  void BuildVectors(vtkRefinementSurface* surface);
  /// Whether the surface gives any two faces other normals at a point they share.
  bool SplitsNormals(vtkRefinementSurface* surface) const;
  void BuildSeams();
  void BuildMergedEdges();

  std::string Error;
  vtkIdType NumberOfDroppedTriangles = 0;
  int NumberOfPoints = 0;

  /// Edges between places, for each face; and per such edge the distinct pairs of point ids.
  std::vector<int> FaceMergedEdges;
  std::vector<int> MergedEdgeOffsets;
  std::vector<std::array<int, 2>> MergedEdgePairs;
};
}

#endif
