// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveFrames
 * @brief   what ribbons and tubes along curves are across to: frames at stations of each curve
 *
 * See glsl/relevoCurveFrames.glsl, which finds the frames between. Where a curve begins at the
 * point that one other ends at, both have the same frame there, across to the mean of their
 * directions, unless they turn right round.
 *
 * Private to the modules' own sources.
 */
#ifndef CurveFrames_h
#define CurveFrames_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkType.h"

#include <vector> // for members

namespace relevo
{
class CurveEvaluator;
class CurveMesh;

class RELEVOFILTERSPARAMETRIC_EXPORT CurveFrames
{
public:
  /// Of a curve.
  struct Stations
  {
    vtkIdType First;  // of Intervals + 1 stations, at t = k / Intervals
    int Intervals;    // a power of two
    bool IsStartOpen; // whether no curve's end is joined here
    bool IsEndOpen;
  };

  void Build(const CurveMesh& mesh);

  /// Have a curve's evaluator use its frames.
  void Set(CurveEvaluator& evaluator, vtkIdType curve) const;

  /// By curve.
  const std::vector<Stations>& GetStations() const { return this->AllStations; }
  //@{
  /// By station; of length 1, and across to each other.
  const std::vector<dvec3>& GetTangents() const { return this->Tangents; }
  const std::vector<dvec3>& GetNormals() const { return this->Normals; }
  //@}

private:
  struct Joints;
  void FindStations(const CurveMesh& mesh);
  void JoinTangents(const CurveMesh& mesh, Joints& joints);
  void FollowNormals(const CurveMesh& mesh, const Joints& joints);
  void FollowChain(const CurveMesh& mesh, const Joints& joints, vtkIdType first);
  void CloseRing(const Joints& joints, vtkIdType first);

  std::vector<Stations> AllStations;
  std::vector<dvec3> Tangents;
  std::vector<dvec3> Normals;
};
}

#endif
