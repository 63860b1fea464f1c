// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   NormalSplits
 * @brief   splits refined points whose faces have different normals
 *
 * At a crease, the faces around a point have different normals. Faces whose normals match share a
 * point, the others get copies. Normals match if they differ by at most 0.001 (the length of the
 * difference of unit vectors, 0.06 degrees), or by a chain of such steps. The result does not
 * depend on the order of the faces.
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
  /// Split the points of a topology. The surface may be nullptr.
  NormalSplits(const RefinementMesh& mesh, vtkRefinementSurface* surface,
    const RefinementEvaluator& evaluator, const RefinedTopology& topology,
    vtkIdType numberOfInputPoints);

  const SplitPoints& GetPoints() const { return this->Points; }

  /// A point as the evaluator computed it for its owner.
  struct Value
  {
    vec3 Position;
    vec3 Normal;
    bool IsKnown = false;
  };
  /// Values by point; empty if no face splits normals.
  std::vector<Value> TakeValues() { return std::move(this->Values); }

private:
  class Visitor;

  std::vector<Value> Values;
  SplitPoints Points;
};
}

#endif
