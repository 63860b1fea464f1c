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
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CellCrossing
{
public:
  /// `cells` must have been moved to the origin and must outlive this object. Optionally computes
  /// the gradient magnitudes of parts of rays, and gradients at their ends.
  CellCrossing(VolumeCells& cells, bool withSteepness, bool withGradients);

  /// Multiplies gradients before their magnitude is computed, for meshes whose coordinates are not
  /// world coordinates.
  void SetGradientTransform(const dmat3& transform) { this->GradientTransform = transform; }

  const VolumeCells& GetCells() const { return this->Cells; }

  /// Prepares Cross() without candidates.
  void BuildTree();

  //@{
  /**
   * Returns the parts of a ray, in world coordinates, inside of cells, from front to back. Can be
   * called from several threads. Optionally only intersects the candidates, whose order does not
   * matter.
   */
  std::vector<RayPart> Cross(const Ray& ray) const;
  std::vector<RayPart> Cross(const Ray& ray, const std::vector<int>& candidates) const;
  //@}

  /// Appends the parts inside of a cell, of a ray relative to the middle of the mesh.
  void AppendParts(size_t number, const Ray& ray, std::vector<RayPart>& parts) const;

  /// Shorter parts are ignored.
  double GetShortest() const;

  /// Returns the scalars at a point, in world coordinates, of a cell that contains it. The number
  /// of the cell is that of a RayPart.
  Scalars Evaluate(size_t cell, const dvec3& point) const;
  /// Returns the gradients there; 0 for cell scalars.
  Gradients ComputeGradients(size_t cell, const dvec3& point) const;

private:
  void CrossTetrahedron(
    const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const;
  void CrossCurved(
    const VolumeCells::Cell& cell, const Ray& ray, std::vector<RayPart>& parts) const;
  void CrossPart(const CurvedPart& part, const Ray& ray, std::vector<RayPart>& parts) const;
  Scalars GetLengths(const Gradients& gradients) const;
  Scalars ComputeSteepness(const VolumeCells::Cell& cell, const CornerSlopes& slopes) const;
  Gradients WeighGradients(const VolumeCells::Cell& cell, const double* weights) const;

  const VolumeCells& Cells;
  bool HasSteepness;
  bool HasGradients;
  dmat3 GradientTransform = dmat3(1.0);
  std::vector<Gradients> PointGradients; // of cells without curved parts, if requested
  FloatBoxTree Tree;                     // empty without BuildTree()
};
}

#endif
