// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A recipe with every metric and surface, and random calls of all of them.
#ifndef RelevoFuzzRecipe_h
#define RelevoFuzzRecipe_h

#include "RelevoFuzz.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkG1Surface.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkProceduralSurface.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScalarTaggedSurface.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkSphere.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <ostream>
#include <string>
#include <vector>

namespace RelevoFuzz
{
class RecipeCalls
{
public:
  explicit RecipeCalls(Dice& dice);

  // Replaces the recipe by another one.
  void Renew();
  vtkAdaptiveRefinement* Get() { return this->Recipe; }
  vtkDepthTagMetric* ChooseMetric() { return this->D.Choose(this->GetMetrics()); }

  void AddTo(std::vector<Call>& calls);

  void Print(std::ostream& text);

private:
  std::vector<vtkDepthTagMetric*> GetMetrics();
  std::vector<vtkRefinementSurface*> GetSurfaces();
  std::string Name() { return ChooseName(this->D); }

  void AddRecipeCalls(std::vector<Call>& calls);
  void AddMetricCalls(std::vector<Call>& calls);
  void AddSurfaceCalls(std::vector<Call>& calls);
  void AddDisplacementCalls(std::vector<Call>& calls);

  Dice& D;
  vtkSmartPointer<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkSphere> Implicit;
  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkDistanceDepthTagMetric> Distance;
  vtkNew<vtkScreenEdgeDepthTagMetric> ScreenEdge;
  vtkNew<vtkCurvatureDepthTagMetric> Curvature;
  vtkNew<vtkSilhouetteDepthTagMetric> Silhouette;
  vtkNew<vtkViewDependentDepthTagMetric> ViewDependent;
  vtkNew<vtkFieldVariationDepthTagMetric> Variation;
  vtkNew<vtkRegionDepthTagMetric> Region;
  vtkNew<vtkCompositeDepthTagMetric> Composite;
  vtkNew<vtkLinearSurface> Linear;
  vtkNew<vtkPNTriangleSurface> PN;
  vtkNew<vtkG1Surface> G1;
  vtkNew<vtkPhongSurface> Phong;
  vtkNew<vtkScalarTaggedSurface> Tagged;
  vtkNew<vtkProceduralSurface> Procedural;
};
}

#endif
