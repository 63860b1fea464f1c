// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveFrames
 * @brief   frames at stations of curves, for ribbons and tubes
 *
 * glsl/relevoCurveFrames.glsl interpolates frames between stations. If a curve begins at the point
 * where exactly one other curve ends, both have the same frame there, perpendicular to the mean of
 * their directions, unless the angle between them is too sharp.
 *
 * Private to the modules.
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
  /// The stations of a curve.
  struct Stations
  {
    vtkIdType First;  // of Intervals + 1 stations at t = k / Intervals
    int Intervals;    // a power of two
    bool IsStartOpen; // whether the start is not joined to the end of a curve
    bool IsEndOpen;
  };

  void Build(const CurveMesh& mesh);

  /// Makes a curve's evaluator use its frames.
  void Set(CurveEvaluator& evaluator, vtkIdType curve) const;

  /// One per curve.
  const std::vector<Stations>& GetStations() const { return this->AllStations; }
  //@{
  /// One per station, normalized and orthogonal.
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
