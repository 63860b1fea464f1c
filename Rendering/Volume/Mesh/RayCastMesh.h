// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayCastMesh
 * @brief   the cells of data sets as one mesh with neighbours, as arrays for the GPU
 *
 * Coincident points with the same scalars are merged. Tetrahedra come first, then curved cells. A
 * tetrahedron takes 20 bytes: its neighbours, and the exclusive or of its four points, which gives
 * the fourth point if three are known (A. S. Aman, S. Demirci, U. Gudukbay, "Compact
 * tetrahedralization-based acceleration structures for ray tracing", Journal of Visualization
 * 2022).
 *
 * If scalars are discontinuous, each corner of a tetrahedron has its own scalars, and all points at
 * the same place are merged. In meshes with curved cells, there are several points at the same
 * place instead. Cells are neighbours if the corners of their faces are at the same places. Points
 * are then sorted by position, so that the corners of a face have the same order in both cells.
 *
 * Next to refined cells, several cells are behind a face. The faces of the smaller cells have one
 * neighbour. Cells whose edges have hanging points are stored as curved cells.
 *
 * Private to the modules' own sources.
 */
#ifndef RayCastMesh_h
#define RayCastMesh_h

#include "Integral/TransferFunctions.h" // for scalars
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/MeshExtent.h"

#include <cstdint>    // for numbers of points and cells
#include <functional> // for points and scalars
#include <string>     // for errors
#include <vector>     // for members

namespace relevo
{
class VolumeCells;

struct RayCastMesh
{
  /// The index for a missing cell.
  static constexpr std::uint32_t InvalidCell = 0xffffffff;
  /// The index for a point without cells.
  static constexpr std::uint32_t UnusedPoint = 0xffffffff;
  static constexpr int WordsOfCurvedCell = 16;
  static constexpr int FirstNeighborWord = 10; // of a curved cell

  /**
   * Build the mesh. If it is too large, return false and an error that continues "The input ".
   * Scalars of cells with several components are stored separately from the points. Corners and
   * gradients are stored on request; scalars of cells have no gradients.
   *
   * If the cells are a piece of a mesh, `whole` is the extent of the whole mesh. Points are then
   * sorted by position, so that the order of two points does not depend on the piece.
   *
   * `known` is an earlier mesh without discontinuous scalars and shared faces, of which only sums,
   * corners, neighbours and curved cells are needed. If it has the same cells of the same points,
   * its neighbours are moved here, unless points hang.
   */
  bool Build(const VolumeCells& cells, int numberOfComponents, std::string& error,
    bool withCorners = false, bool withGradients = false, const MeshExtent* whole = nullptr,
    RayCastMesh* known = nullptr);

  enum class ScalarOwner
  {
    Points,
    Cells,
    Corners // of tetrahedra
  };

  /// Store points with the transformation of positions.
  void SetPoints(size_t count, const std::function<dvec3(size_t)>& get);
  /// Return a position as it is stored.
  dvec3 GetStored(const dvec3& point) const;
  /// Scale the scalars of all points, cells or corners by the extent's ranges, and store them after
  /// the points.
  void SetScalars(size_t count, const std::function<Scalars(size_t)>& get, int numberOfComponents,
    ScalarOwner owner, const MeshExtent& whole);

  /// Store the gradients of points or corners. The components of each follow each other.
  void SetGradients(
    size_t count, const std::function<const dvec3*(size_t)>& get, int numberOfComponents);

  /// Free the arrays. The transformations of positions and scalars stay.
  void Release();

  size_t GetNumberOfPoints() const { return this->Points.size() / 4; }
  size_t GetNumberOfTetrahedra() const { return this->PointSums.size(); }
  size_t GetNumberOfCurvedCells() const
  {
    return (this->CurvedCells.size() - this->NumberOfListWords) / WordsOfCurvedCell;
  }

  //@{
  /// A position is Center + Radius * point; a scalar is ScalarLow + ScalarSize * stored value.
  dvec3 Center = dvec3(0.0);
  double Radius = 1.0;
  dvec3 HalfSize = dvec3(0.0); // of the points' box
  double LongestEdge = 0.0;    // or diagonal of a cell
  Scalars ScalarLow = {};
  Scalars ScalarSize = {};
  Scalars ScalarHigh = {}; // the highest value
  //@}

  //@{
  /// The sources of scalars: for each point of the data sets its point here, or UnusedPoint; for
  /// each cell here the tuple of its scalars, if they are of cells; and for each corner its point
  /// of the data sets, if corners have scalars.
  std::vector<std::uint32_t> PointIds;
  std::vector<vtkIdType> CellIds;
  std::vector<std::uint32_t> CornerIds;
  //@}

  std::vector<float> Points;       // x, y, z, and the scalar if there is only one component
  std::vector<float> PointScalars; // 4 per point for several components
  std::vector<float> CellScalars;  // of cell scalars: 1 per cell, or 4 for several components
  /// The scalars of each tetrahedron's corners in the order of its points: 1 per corner, or 4 for
  /// several components.
  std::vector<float> CornerScalars;
  bool HasCornerScalars = false;
  /// The gradients of all components at each point, or at each corner if corners have scalars, on
  /// request: 4 floats each, of which the last is 0. A gradient is ScalarSize / Radius * stored
  /// value.
  std::vector<float> PointGradients;

  /// The exclusive or of each tetrahedron's points.
  std::vector<std::uint32_t> PointSums;
  /// The points of each tetrahedron in ascending order, on request or if IsDiscontinuous.
  std::vector<std::uint32_t> Corners;
  /// The neighbours of each tetrahedron: the cell that shares all points except the lowest one, and
  /// so on. If IsDiscontinuous, 8 * cell + the index of the face in that cell's neighbours, or +
  /// SamePoints.
  std::vector<std::uint32_t> Neighbors;
  /// Whether there are points with different scalars at the same place, or hanging points.
  bool IsDiscontinuous = false;
  /// Whether several cells are behind some faces.
  bool HasHangingFaces = false;
  /// For neighbours with the same points at the face. A curved cell with other points has 0.
  static constexpr std::uint32_t SamePoints = 4;
  /// For a face of a curved cell with several cells behind it: 8 * address + SeveralCells. See
  /// HangingRecords.
  static constexpr std::uint32_t SeveralCells = 5;

  /**
   * The curved cells, 16 words each: 8 points of a hexahedron, or 10 of a quadratic tetrahedron,
   * whose last word is `Quadratic`. From word 10 on, the cells behind its faces follow in the order
   * of their CellShapes, as in Neighbors. Wedges and pyramids are hexahedra with coincident points,
   * which does not change positions and scalars. All cells are oriented so that their faces point
   * outwards. Word 8 of a hexahedron is the address of the list of its edges, or 0. The lists of
   * HangingRecords follow the cells.
   */
  std::vector<std::uint32_t> CurvedCells;
  size_t NumberOfListWords = 0;
  static constexpr std::uint32_t Quadratic = 0xfffffff0;
  bool HasQuadraticCells = false;
  bool HasPyramids = false;
  /// Whether some faces of curved cells are not flat, so that a ray can leave and enter through
  /// them.
  bool HasFoldedFaces = false;

  /**
   * The border faces, in the order of the tree's leaves. A face of a tetrahedron has three points,
   * in order as seen by an entering ray, and the tetrahedron. A face of a curved cell has its index
   * in the cell's shape, twice 0, and the cell.
   */
  std::vector<std::uint32_t> BorderFaces;
  std::vector<float> BorderTree; // see FlattenTree()
  /// The number of faces with several cells on the same side, which are treated as border faces.
  size_t NumberOfSharedFaces = 0;
  bool HasKnownNeighbors = false; // of an earlier mesh
};
}

#endif
