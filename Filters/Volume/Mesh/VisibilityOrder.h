// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VisibilityOrder
 * @brief   3D cells of a mesh from back to front, by which cell hides which across their face
 *
 * MPVO-NC: P. Williams, "Visibility Ordering Meshed Polyhedra", 1992. A cell comes after those
 * behind its faces. Depth-first searches start at faces of the border that the eye sees, the
 * farthest first, which is a guess where the mesh is not convex.
 *
 * Private to the module's own sources.
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
   * Once for a mesh. Points at one place have one id. Points that are not finite order nothing.
   */
  void Build(const std::vector<dvec3>& points, CellFaces cells);

  /**
   * All cells, those that are hidden before those that hide them. The eye is a place (x, y, z, 1),
   * or a direction towards a viewer far away (x, y, z, 0), in the points' coordinates.
   */
  const std::vector<int>& Sort(const dvec4& eye);

  /// Of the last Sort(): faces whose order did not count, because it closed a cycle.
  vtkIdType GetNumberOfCycles() const { return this->NumberOfCycles; }

private:
  void FindHidden(const dvec4& eye);
  std::vector<int> FindStarts(const dvec4& eye) const;
  void Visit(int start);

  CellLinks Mesh;
  std::vector<std::array<int, 2>> Slots; // of each link, with its cells
  std::vector<int> FirstSlots;           // of each cell, and the end

  // Of the last Sort().
  std::vector<int> Hidden; // by slots: which cell is behind the face, else -1
  std::vector<unsigned char> Marks;
  std::vector<std::pair<int, int>> Stack; // cells and their next slots
  std::vector<int> Order;
  vtkIdType NumberOfCycles = 0;
};
}

#endif
