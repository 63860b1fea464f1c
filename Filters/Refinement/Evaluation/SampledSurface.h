// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SampledSurface
 * @brief   the displaced surface of a recipe, by samples of the coarse faces
 *
 * Faces are sampled as finely as they are refined, with at least 4 and at most 16 segments on an
 * edge. Each sample inside a face has the discrete curvature of the ring of samples around it. A
 * point of the mesh has the mean of the absolute curvatures of the faces at it, weighted by their
 * areas. So relief counts that lies between the mesh's points.
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
  /// That of a recipe, which must outlive it; nullptr where no height map displaces the mesh.
  static std::shared_ptr<const SampledSurface> Make(vtkAdaptiveRefinement* recipe);

  explicit SampledSurface(vtkAdaptiveRefinement* recipe);

  void AddTo(Dependencies& dependencies) const override;
  DiscreteCurvature ComputeCurvature(
    vtkPolyData* mesh, const GlobalSurfaceInfo* whole) const override;

private:
  vtkAdaptiveRefinement* Recipe;
};
}

#endif
