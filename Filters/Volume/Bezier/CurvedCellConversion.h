// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedCellConversion
 * @brief   converts the nodes of curved VTK cells to Bézier hexahedra
 *
 * The conversion of a cell type and degree is a matrix. It follows from the values of
 * vtkCell::InterpolateFunctions() at a lattice of parameters, so that positions and scalars are
 * those of the cell's own basis, whatever the type. The result is compared with these functions at
 * other parameters; the degrees are raised until both are equal.
 *
 * A hexahedron or pyramid is one Bézier hexahedron, which is degenerate at the apex of a pyramid. A
 * wedge is three of them and a tetrahedron four, one at each corner of the triangle or tetrahedron,
 * which meet at midpoints of edges and centres of faces. If a mesh has cells of both kinds, edges
 * of hexahedra and pyramids are halved too, so that all cells match.
 *
 * Private to the module.
 */
#ifndef CurvedCellConversion_h
#define CurvedCellConversion_h

#include "Bezier/BezierHexahedron.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace relevo
{
/// The type of a curved cell.
struct CurvedCellType
{
  int Type; // of VTK
  ivec3 Degrees;
  vtkIdType NumberOfNodes;
  bool IsHalved; // whether all edges are halved

  bool operator<(const CurvedCellType& other) const;
};

/// A node: position, weight and scalars.
struct CurvedNode
{
  dvec3 Position;
  double Weight;
  Scalars Values;
};

class CurvedCellConversion
{
public:
  CurvedCellConversion();
  ~CurvedCellConversion();

  /// Whether the type can be converted. Not thread-safe.
  bool Prepare(const CurvedCellType& type);

  /// Converts a cell whose type has been prepared. Returns nothing for other types. Can be called
  /// from several threads.
  std::vector<BezierHexahedron> Convert(
    const CurvedCellType& type, const std::vector<CurvedNode>& nodes, int numberOfScalars) const;

  /// Computes the weights of the nodes, which add up to 1, at a point of a converted part.
  void FindWeights(const CurvedCellType& type, size_t part, const std::vector<CurvedNode>& nodes,
    const dvec3& parameters, double* weights) const;

private:
  class Matrix;

  const Matrix* Find(const CurvedCellType& type) const;

  std::map<CurvedCellType, std::unique_ptr<Matrix>> Matrices;
};
}

#endif
