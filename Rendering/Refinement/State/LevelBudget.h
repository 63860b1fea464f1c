// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LevelBudget
 * @brief   what a mapper adds to the levels of its meshes to keep to numbers of triangles and times
 *
 * Works only when something changed: the tags of a view, the faces that are culled, the target, or
 * the limit that the allowed time sets. CPU side only. Private to the module.
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
  /// A mesh with the tags of a view and the faces that are culled, and when these were found.
  struct Part
  {
    TriangleBudget::Part Mesh;
    vtkMTimeType TagsTime;
    vtkMTimeType SightTime;
  };

  /// Wanted number of triangles, 0 for none.
  vtkIdType Target = 0;

  /**
   * A pass has drawn the meshes; all passes of a frame are added up. `first` tells that a frame
   * begins.
   */
  void AddPass(bool first, vtkIdType triangles, double seconds);

  /**
   * Turn to a view, known by its camera. `seconds` is the time allowed, 0 for any, negative to keep
   * the limit that was found last for this view. Returns whether there is anything to keep to.
   */
  bool SetView(const vtkCamera* camera, double seconds);

  /**
   * The offset, in levels, to be added to the recipe's own, for all parts of the view: of several
   * processes, the one that all can keep to. Collective.
   */
  double FindOffset(
    const std::vector<Part>& parts, vtkAdaptiveRefinement* recipe, const PieceReduction& pieces);

private:
  struct View
  {
    const vtkCamera* Camera = nullptr; // to compare, never read
    Dependencies State;
    double Offset = 0.0; // with the recipe's own
    vtkIdType Limit = 0;
  };

  TriangleBudget Triangles;
  RenderTimeBudget Times;
  std::vector<View> Views; // the present one last
  vtkIdType FrameTriangles = 0;
  double FrameSeconds = 0.0;
};
}

#endif
