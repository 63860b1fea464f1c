// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SampledSurface
 * @brief   the displaced surface of a recipe, sampled on the coarse faces
 *
 * Faces are sampled at their finest refinement, with at least 4 and at most 16 segments per edge.
 * Each sample inside a face has the discrete curvature of the ring of samples around it. A point of
 * the mesh has the area-weighted mean of the absolute curvatures of its faces. Relief between the
 * mesh's points is therefore included.
 */
#ifndef SampledSurface_h
#define SampledSurface_h

#include "Metrics/DisplacedSurface.h"
#include "RelevoFiltersRefinementModule.h" // for export macro

#include <memory> // for Make

class vtkAdaptiveRefinement;

namespace relevo
{
class RELEVOFILTERSREFINEMENT_EXPORT SampledSurface : public DisplacedSurface
{
public:
  /// Create the surface of a recipe, which must outlive it. Returns nullptr if there is no height
  /// map.
  static std::shared_ptr<const SampledSurface> Make(vtkAdaptiveRefinement* recipe);

  explicit SampledSurface(vtkAdaptiveRefinement* recipe);

  void AddTo(Dependencies& dependencies) const override;
  DiscreteCurvature ComputeCurvature(
    vtkPolyData* mesh, const GlobalSurfaceInfo* whole) const override;
  std::unique_ptr<DisplacedFaces> MakeFaces(vtkPolyData* mesh, const GlobalSurfaceInfo* whole,
    std::shared_ptr<const PatternFamily> patterns) const override;
  int GetMaximumLevel() const override;

private:
  vtkAdaptiveRefinement* Recipe;
};
}

#endif
