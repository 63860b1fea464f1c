// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedLevels
 * @brief   the patterns of a mapper's faces for pickers
 *
 * They are the patterns that were drawn last, with the levels of the method: rounded if it does not
 * morph, and all of the highest level if it draws only that one. If nothing has been drawn since
 * the mesh or the levels changed, the recipe's levels are used. For view-dependent metrics, whose
 * camera is not known then, this is MaximumLevel everywhere.
 */
#ifndef PickedLevels_h
#define PickedLevels_h

#include "Changes/Dependencies.h"        // for members
#include "Evaluation/PatternSelection.h" // for members
#include "Methods/RefinementMethod.h"    // for Kinds
#include "vtkType.h"                     // for vtkMTimeType

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
class RefinementMesh;
class ViewSelection;

class PickedLevels
{
public:
  using Kinds = RefinementMethod::DrawnLevels;

  /**
   * Return the patterns for a mesh of the input, built at `meshTime`, and the selection that was
   * drawn last. Return nullptr if the recipe cannot be applied.
   */
  const PatternSelection* Get(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
    const RefinementMesh& mesh, vtkMTimeType meshTime, const ViewSelection& drawn, Kinds kind);

private:
  bool SelectAnew(vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementMesh& mesh,
    const ViewSelection& drawn);
  void Round(const PatternSelection& drawn, vtkAdaptiveRefinement* recipe,
    const RefinementMesh& mesh, bool toHighest);
  template <typename GetSegments>
  void Assign(
    vtkAdaptiveRefinement* recipe, const RefinementMesh& mesh, const GetSegments& getSegments);

  PatternSelection Own;
  Dependencies OwnDependencies;
  bool Valid = false;
};
}

#endif
