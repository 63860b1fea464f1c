// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellCrossing
 * @brief   finds the cells that a ray passes through
 *
 * Private to the module's own sources.
 */
#ifndef CellCrossing_h
#define CellCrossing_h

#include "Boxes/FaceTree.h"
#include "Cells/Ray.h"
#include "Cells/VolumeCells.h"

#include <vector>

namespace relevo
{
class CellCrossing
{
public:
  /// The cells are moved to the origin, and stay elsewhere. Parts of rays may have the lengths of
  /// the scalars' gradients, and gradients at their ends.
  CellCrossing(VolumeCells& cells, bool withSteepness, bool withGradients);

  const VolumeCells& GetCells() const { return this->Cells; }

  /// The parts of a ray, of world coordinates, inside cells, from front to back. In several
  /// threads.
  std::vector<RayPart> Cross(const Ray& ray) const;

private:
  void CrossTetrahedron(
    const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const;
  void CrossCurved(
    const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const;
  Scalars ComputeSteepness(const VolumeCells::Cell& cell, const CornerSlopes& slopes) const;
  Gradients WeighGradients(const VolumeCells::Cell& cell, const double* weights) const;

  const VolumeCells& Cells;
  bool HasSteepness;
  std::vector<Gradients> PointGradients; // if wanted
  FaceTree Tree;
};
}

#endif
