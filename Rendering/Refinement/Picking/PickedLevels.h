// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedLevels
 * @brief   the patterns that pickers find a mapper's faces refined to
 *
 * Those that were drawn last, as far as the method drew these: rounded where it does not morph, and
 * all of the highest level where it draws nothing else. Where nothing has been drawn since mesh or
 * levels changed, what the recipe asks for; of metrics of the view, whose camera is not known then,
 * MaximumLevel everywhere.
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
   * For a mesh of the input, built at `meshTime`, and what was drawn last. nullptr when the recipe
   * cannot be applied.
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
