// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementEvaluator
 * @brief   points, normals and holes of a refined mesh, on the CPU
 *
 * Evaluates the same functions as the shaders, at pattern vertices of prepared faces. All methods
 * may be called from several threads.
 *
 * Not wrapped: for the modules' own sources.
 */
#ifndef vtkRefinementEvaluator_h
#define vtkRefinementEvaluator_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <memory> // for std::unique_ptr

class vtkAdaptiveRefinement;

#ifndef __VTK_WRAP__
namespace relevo
{
class PatternSelection;
class RefinementMesh;
struct FacePattern;

class RELEVOFILTERSREFINEMENT_EXPORT RefinementEvaluator
{
public:
  /**
   * For a mesh built with the recipe. Both must outlive the evaluator, and the displacement's
   * height map must be up to date.
   */
  RefinementEvaluator(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe);
  ~RefinementEvaluator();

  /**
   * Position relative to the mesh's origin and unit normal (zero when the mesh has no normals).
   */
  void Evaluate(int face, const float weights[3], float position[3], float normal[3]) const;

  /**
   * Mark the pattern's triangles that a displacement with holes leaves out on this face: those with
   * a vertex whose height, or with a sample in them that, has no data. `out` holds a byte per
   * triangle, 1 where left out. Returns how many there are.
   */
  int FindHoles(int face, const FacePattern& pattern, unsigned char* out) const;

  /**
   * Whether FindHoles can find any on this face.
   */
  bool MayHaveHoles(int face) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};

/**
 * Number of triangles of a selection that a displacement with holes leaves out; 0 without.
 */
RELEVOFILTERSREFINEMENT_EXPORT vtkIdType CountHoles(
  const RefinementMesh& mesh, const PatternSelection& selection, vtkAdaptiveRefinement* recipe);
}
#endif

#endif
