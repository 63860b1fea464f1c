// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   NormalSplits
 * @brief   where the faces around a refined point give it different normals
 *
 * A surface may give the faces around a point normals of their own: a crease. Faces whose normals
 * agree share a point, others have copies of it. Normals agree when they differ by at most 0.001
 * (the length of the difference of unit vectors, 0.06 degrees), or by a chain of such steps. What
 * agrees, and the normal that is shared, do not depend on the order of the faces.
 */
#ifndef NormalSplits_h
#define NormalSplits_h

#include "Evaluation/SplitPoints.h"
#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

#include <utility>
#include <vector>

class vtkRefinementSurface;

namespace relevo
{
class RefinedTopology;
class RefinementEvaluator;
class RefinementMesh;

class NormalSplits
{
public:
  /// For points as a topology shares them; the surface may be nullptr.
  NormalSplits(const RefinementMesh& mesh, vtkRefinementSurface* surface,
    const RefinementEvaluator& evaluator, const RefinedTopology& topology,
    vtkIdType numberOfInputPoints);

  const SplitPoints& GetPoints() const { return this->Points; }

  /// A point as the evaluator gave it for its owner.
  struct Value
  {
    vec3 Position;
    vec3 Normal;
    bool IsKnown = false;
  };
  /// By point; empty where no face splits normals.
  std::vector<Value> TakeValues() { return std::move(this->Values); }

private:
  class Visitor;

  std::vector<Value> Values;
  SplitPoints Points;
};
}

#endif
