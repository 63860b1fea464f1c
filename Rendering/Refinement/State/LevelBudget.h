// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LevelBudget
 * @brief   the level offset with which a mapper's meshes meet a number of triangles or a time limit
 *
 * The offset is computed again only when the tags of a view, the culled faces, the target or the
 * time limit have changed. It runs on the CPU. Private to the module.
 */
#ifndef LevelBudget_h
#define LevelBudget_h

#include "Changes/Dependencies.h"        // for members
#include "Evaluation/RenderTimeBudget.h" // for members
#include "Evaluation/TriangleBudget.h"   // for members

#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkCamera;

namespace relevo
{
class PieceReduction;
class LevelBudget
{
public:
  /// A mesh with the tags of a view and the culled faces, and their modification times.
  struct Part
  {
    TriangleBudget::Part Mesh;
    vtkMTimeType TagsTime;
    vtkMTimeType SightTime;
  };

  /// The target number of triangles, 0 for none.
  vtkIdType Target = 0;

  /**
   * Add the triangles and the time of a pass; all passes of a frame are added up. `first` starts a
   * frame.
   */
  void AddPass(bool first, vtkIdType triangles, double seconds);

  /**
   * Switch to a view, identified by its camera. `seconds` is the allowed time, 0 for no limit,
   * negative for the last limit of this view. Return whether there is a target or a limit.
   */
  bool SetView(const vtkCamera* camera, double seconds);

  /**
   * Return the offset, in levels, to add to the recipe's offset for all parts of the view. With
   * several processes it is the same for all. Collective.
   */
  double FindOffset(
    const std::vector<Part>& parts, vtkAdaptiveRefinement* recipe, const PieceReduction& pieces);

private:
  struct View
  {
    const vtkCamera* Camera = nullptr; // for comparison; it is not dereferenced
    Dependencies State;
    double Offset = 0.0; // including the recipe's
    vtkIdType Limit = 0;
  };

  TriangleBudget Triangles;
  RenderTimeBudget Times;
  std::vector<View> Views; // the current one is last
  vtkIdType FrameTriangles = 0;
  double FrameSeconds = 0.0;
};
}

#endif
