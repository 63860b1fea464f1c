// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceMeasure
 * @brief   measures the deviation of one face's pattern, see SampledFaces
 */
#ifndef FaceMeasure_h
#define FaceMeasure_h

#include "Metrics/DisplacedFaces.h" // for FaceDeviations

#include <memory> // for members

class vtkAdaptiveRefinement;

namespace relevo
{
class HoleFinder;
class RefinementMesh;
struct FacePattern;

class FaceMeasure
{
public:
  /// For a mesh that was built with a recipe, which has a height map. `holes` may be nullptr. All
  /// must outlive this object.
  FaceMeasure(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe, const HoleFinder* holes);
  ~FaceMeasure();

  /// Return the deviations of a face. Thread-safe for different faces.
  FaceDeviations Measure(int face, const FacePattern& pattern);

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
