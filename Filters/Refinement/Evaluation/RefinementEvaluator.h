// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementEvaluator
 * @brief   evaluates points and normals of a refined mesh on the CPU
 *
 * It calls the same functions as the shaders, at pattern vertices of prepared faces. All methods
 * are thread-safe.
 */
#ifndef RefinementEvaluator_h
#define RefinementEvaluator_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkAdaptiveRefinement;

namespace relevo
{
class RefinementMesh;

class RELEVOFILTERSREFINEMENT_EXPORT RefinementEvaluator
{
public:
  /**
   * Create an evaluator for a mesh that was built with the recipe. Both must outlive the evaluator,
   * and the displacement's height map must be up to date.
   */
  RefinementEvaluator(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe);
  ~RefinementEvaluator();

  /**
   * Get the position relative to the mesh's origin and the unit normal, which is 0 if the mesh has
   * no normals.
   */
  void Evaluate(int face, const float weights[3], float position[3], float normal[3]) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
