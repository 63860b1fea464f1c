// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellSection
 * @brief   the polygons and lines where a surface meets a cell
 *
 * Private to the module.
 */
#ifndef CellSection_h
#define CellSection_h

#include "Mathematics/RefinementMathematics.h"
#include "Sections/PolyhedronSection.h"
#include "vtkType.h"

#include <array>
#include <vector>

namespace relevo
{
struct CellSection
{
  std::vector<vtkIdType> Nodes; // the cell's points in the data set
  std::vector<dvec3> Points;
  std::vector<double> Weights; // of the nodes, for each point
  /// For each point the two points of the data set whose edge it divides, in increasing order,
  /// twice the same for a point at a node. Both are -1 in curved cells.
  std::vector<std::array<vtkIdType, 2>> Edges;
  std::vector<std::vector<int>> Polygons;
  std::vector<std::array<int, 2>> Lines; // on the faces of the cell

  /// Adds the section of the cell or a part of it. `points` has the point on each crossed edge.
  /// Faces that are not outer ones add no lines.
  void Add(const PolyhedronSection& cut, const std::vector<int>& points,
    const std::vector<unsigned char>& isOuter);
};
}

#endif
