// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VisibilityOrder
 * @brief   sorts 3D cells from back to front by their common faces
 *
 * Implements MPVO-NC: P. Williams, "Visibility Ordering Meshed Polyhedra", 1992. A cell comes after
 * the cells behind its faces. Depth-first searches start at the border faces that the eye sees, the
 * farthest first. This is a heuristic if the mesh is not convex.
 *
 * Private to the module.
 */
#ifndef VisibilityOrder_h
#define VisibilityOrder_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/CellFaces.h"
#include "Mesh/CellLinks.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT VisibilityOrder
{
public:
  /**
   * Prepares a mesh. Coincident points must have one id. Cells with points that are not finite get
   * any position in the order.
   */
  void Build(const std::vector<dvec3>& points, CellFaces cells);

  /**
   * Returns all cells, each after the cells that it hides. The eye is a position (x, y, z, 1), or
   * the direction to a viewer at infinity (x, y, z, 0), in the coordinates of the points.
   */
  const std::vector<int>& Sort(const dvec4& eye);

  /// Returns the number of faces that the last Sort() ignored to break cycles.
  vtkIdType GetNumberOfCycles() const { return this->NumberOfCycles; }

private:
  void FindHidden(const dvec4& eye);
  std::vector<int> FindStarts(const dvec4& eye) const;
  void Visit(int start);

  CellLinks Mesh;
  std::vector<std::array<int, 2>> Slots; // slots of the two cells of each link
  std::vector<int> FirstSlots;           // first slot of each cell, and the number of slots

  // Result and temporary data of the last Sort().
  std::vector<int> Hidden; // for each slot the cell behind the face, or -1
  std::vector<unsigned char> Marks;
  std::vector<std::pair<int, int>> Stack; // cells and their next slots
  std::vector<int> Order;
  vtkIdType NumberOfCycles = 0;
};
}

#endif
