// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellCrossing
 * @brief   finds the cells that a ray passes through
 *
 * Private to the module.
 */
#ifndef CellCrossing_h
#define CellCrossing_h

#include "Boxes/BoxTree.h"
#include "Cells/VolumeCells.h"
#include "Integral/Ray.h"

#include <vector>

namespace relevo
{
class CellCrossing
{
public:
  /// `cells` must have been moved to the origin and must outlive this object. Optionally computes
  /// the gradient magnitudes of parts of rays, and gradients at their ends.
  CellCrossing(VolumeCells& cells, bool withSteepness, bool withGradients);

  const VolumeCells& GetCells() const { return this->Cells; }

  /// Returns the parts of a ray, in world coordinates, inside of cells, from front to back. Can be
  /// called from several threads.
  std::vector<RayPart> Cross(const Ray& ray) const;

private:
  void CrossTetrahedron(
    const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const;
  void CrossCurved(
    const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const;
  void CrossPart(const CurvedPart& part, const Ray& ray, std::vector<RayPart>& parts) const;
  Scalars ComputeSteepness(const VolumeCells::Cell& cell, const CornerSlopes& slopes) const;
  Gradients WeighGradients(const VolumeCells::Cell& cell, const double* weights) const;

  const VolumeCells& Cells;
  bool HasSteepness;
  bool HasGradients;
  std::vector<Gradients> PointGradients; // of cells without curved parts, if requested
  FloatBoxTree Tree;
};
}

#endif
