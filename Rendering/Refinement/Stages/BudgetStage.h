// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BudgetStage
 * @brief   keeps a mapper's frames near a number of triangles and within the time that VTK allots
 *
 * It measures the passes and finds the offset that LevelBudget adds to all levels. Private to the
 * module.
 */
#ifndef BudgetStage_h
#define BudgetStage_h

#include "OpenGL/RenderClock.h" // for members
#include "State/LevelBudget.h"  // for members

#include <functional> // for drawing
#include <vector>     // for parts

class vtkActor;
class vtkAdaptiveRefinement;
class vtkRenderer;

namespace relevo
{
class PieceReduction;

class BudgetStage
{
public:
  /// Return the target number of triangles, which the user can change; 0 for none.
  vtkIdType& GetTarget() { return this->Budget.Target; }

  struct Input
  {
    vtkRenderer* Renderer;
    vtkActor* Actor;
    /// Whether frames must keep to the time that VTK allots.
    bool UsesAllocatedTime;
    /// The reduction over several processes, before a frame; nullptr in a pass of one process.
    const PieceReduction* Pieces;
  };
  /**
   * Begin a view. Return whether there is a budget in any process.
   */
  bool Begin(const Input& input);

  /// Return the offset, in levels, for all parts of the view.
  double FindOffset(const std::vector<LevelBudget::Part>& parts, vtkAdaptiveRefinement* recipe,
    const PieceReduction* pieces);

  /**
   * Measure a pass: call draw(), then countTriangles(isSlow). isSlow means that the pass took
   * longer than allotted.
   */
  void Measure(vtkRenderer* renderer, vtkActor* actor, const std::function<void()>& draw,
    const std::function<vtkIdType(bool isSlow)>& countTriangles);

  void ReleaseGraphicsResources() { this->Clock.ReleaseGraphicsResources(); }

private:
  LevelBudget Budget;
  RenderClock Clock;
};
}

#endif
