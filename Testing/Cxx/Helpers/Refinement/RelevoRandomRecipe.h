// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random meshes and recipes of every kind, for tests of invariants.
#ifndef RelevoRandomRecipe_h
#define RelevoRandomRecipe_h

#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkTestErrorObserver.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <array>
#include <initializer_list>
#include <random>

namespace RelevoRandomRecipe
{
using RelevoMeshes::Mesh;
using RelevoMeshes::Triangle;

using Point = std::array<double, 3>;

class Dice
{
public:
  explicit Dice(unsigned int seed);
  // Returns 0 to n - 1.
  int Choose(int n) { return static_cast<int>(this->Engine() % static_cast<unsigned int>(n)); }
  // Returns true once in n times.
  bool Once(int n) { return this->Choose(n) == 0; }
  double Between(double low, double high);
  // From low to high, with a uniform logarithm.
  double Scale(double low, double high);

private:
  std::mt19937 Engine;
};

Point RandomPoint(Dice& dice, bool onLattice);

vtkSmartPointer<vtkFloatArray> RandomArray(
  Dice& dice, const char* name, vtkIdType size, double low, double high, int oneNaNIn);

// Random faces between some points. They either share the points, or each face has separate
// coincident points.
Mesh RandomFaces(Dice& dice);

// The array "Corner" distinguishes the mesh's points from points added by refinement.
Mesh RandomMesh(Dice& dice);

// A filter whose recipe, camera and input are repeatedly set at random.
class Machine
{
public:
  Machine();

  void Shuffle(Dice& dice);

  // Whether it succeeded.
  bool Run();

  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
  vtkNew<vtkScreenEdgeDepthTagMetric> ScreenEdge;
  Mesh Input;

private:
  void ShuffleMetrics(Dice& dice);

  void ShuffleRecipe(Dice& dice);

  void ShuffleCamera(Dice& dice);

  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkCamera> Camera;
  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkLinearSurface> Linear;
  vtkNew<vtkPNTriangleSurface> Quadratic;
  vtkNew<vtkPNTriangleSurface> LinearNormals;
  vtkNew<vtkDistanceDepthTagMetric> Distance;
  vtkNew<vtkSilhouetteDepthTagMetric> Silhouette;
  vtkNew<vtkViewDependentDepthTagMetric> ViewDependent;
  vtkNew<vtkRegionDepthTagMetric> Region;
  vtkNew<vtkFieldVariationDepthTagMetric> Variation;
  vtkNew<vtkCurvatureDepthTagMetric> Curvature;
  vtkNew<vtkCompositeDepthTagMetric> Composite;
};
}

#endif
