// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RayCastMesh
 * @brief   cells of data sets as one mesh, with who is behind each face: arrays for the GPU
 *
 * Points at the same place with the same scalars are one. Tetrahedra come first, then curved cells.
 * A tetrahedron keeps the exclusive or of its four points, as who knows three of them needs no more
 * (A. S. Aman, S. Demirci, U. Gudukbay, "Compact tetrahedralization-based acceleration structures
 * for ray tracing", Journal of Visualization 2022), and its neighbours: 20 bytes.
 *
 * Private to the modules' own sources.
 */
#ifndef RayCastMesh_h
#define RayCastMesh_h

#include "Integral/TransferFunctions.h"

#include <cstdint> // for numbers of points and cells
#include <string>  // for errors
#include <vector>  // for members

namespace relevo
{
class VolumeCells;

struct RayCastMesh
{
  /// In place of a cell: there is none.
  static constexpr std::uint32_t InvalidCell = 0xffffffff;
  static constexpr int WordsOfCurvedCell = 16;

  /**
   * false with words that follow "The input " where the mesh is too large. Of cells whose scalars
   * have more than one component, all are kept apart from the points. Corners are kept if wanted,
   * and gradients, which scalars of cells have not.
   */
  bool Build(const VolumeCells& cells, int numberOfComponents, std::string& error,
    bool withCorners = false, bool withGradients = false);

  /// Free the arrays; where places and scalars are stays.
  void Release();

  size_t GetNumberOfPoints() const { return this->Points.size() / 4; }
  size_t GetNumberOfTetrahedra() const { return this->PointSums.size(); }
  size_t GetNumberOfCurvedCells() const { return this->CurvedCells.size() / WordsOfCurvedCell; }

  //@{
  /// A place is Center + Radius * point, a scalar ScalarLow + ScalarSize * what is stored.
  dvec3 Center = dvec3(0.0);
  double Radius = 1.0;
  dvec3 HalfSize = dvec3(0.0); // of the points' box
  double LongestEdge = 0.0;    // or diagonal, of a cell
  Scalars ScalarLow = {};
  Scalars ScalarSize = {};
  Scalars ScalarHigh = {}; // the highest
  //@}

  std::vector<float> Points;       // x, y, z, and the scalar if there is one component
  std::vector<float> PointScalars; // of several components, 4 for each point
  std::vector<float> CellScalars;  // of cells, if they have them: 1, or 4 of several components
  /// Of each point those of all components, if asked for: 4 each, of which the last is 0. A
  /// gradient is ScalarSize / Radius * what is stored.
  std::vector<float> PointGradients;

  /// Of each tetrahedron the exclusive or of its points.
  std::vector<std::uint32_t> PointSums;
  /// Of each tetrahedron its points, in ascending order; if wanted.
  std::vector<std::uint32_t> Corners;
  /// Of each tetrahedron the cells that share all its points but the lowest one, and so on.
  std::vector<std::uint32_t> Neighbors;

  /**
   * Of each curved cell 16 words: 8 points of a hexahedron, or 10 of a quadratic tetrahedron, whose
   * last word is `Quadratic`; from word 10 on the cells behind its faces, in the order of their
   * CellShapes. Wedges and pyramids are hexahedra some of whose points are the same, which changes
   * neither places nor scalars. All cells are turned so that their faces look outwards.
   */
  std::vector<std::uint32_t> CurvedCells;
  static constexpr std::uint32_t Quadratic = 0xfffffff0;
  bool HasQuadraticCells = false;
  bool HasPyramids = false;
  /// Faces of curved cells that are not flat, so that rays may go through them and back.
  bool HasFoldedFaces = false;

  /**
   * Of each face that no other cell is behind: three points, in turn as seen from where one enters,
   * and the tetrahedron; or the number of the face in the cell's shape, two times 0, and the curved
   * cell. In the order of the tree's leaves.
   */
  std::vector<std::uint32_t> BorderFaces;
  std::vector<float> BorderTree; // as of FlattenTree()
  /// Faces of three cells or more, which count as border.
  size_t NumberOfSharedFaces = 0;
};
}

#endif
