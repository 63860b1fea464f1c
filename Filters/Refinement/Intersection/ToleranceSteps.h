// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ToleranceSteps
 * @brief   into how many segments edges are cut for faces to be as near to their surface as asked
 *
 * A face first gets the least step that would do if its three edges were alike, measured once and
 * kept. An edge has the largest step of the faces at it that are wanted. Where the edges of a face
 * differ its triangles are others, and can be longer: the least of them rise until these are near
 * enough, too. So the steps depend on which faces are wanted, not on what was asked before.
 */
#ifndef ToleranceSteps_h
#define ToleranceSteps_h

#include "Patterns/FacePattern.h" // for return value
#include "vtkType.h"              // for vtkIdType

#include <array>   // for Steps
#include <memory>  // for families
#include <utility> // for std::pair
#include <vector>  // for members

class vtkAdaptiveRefinement;

namespace relevo
{
class PatternDeviation;
class PatternFamily;
class RefinedSurface;
class RefinementMesh;

class ToleranceSteps
{
public:
  /// Take a surface anew, and the edges of its faces; all of it must outlive this.
  void Take(const RefinementMesh& mesh, const RefinedSurface& surface,
    vtkAdaptiveRefinement* recipe, std::vector<int> faceEdges, int numberOfEdges);

  /// Choose for the faces that are wanted, a byte for each. Returns how many of them deviate by
  /// more than the tolerance though their edges have as many segments as can be, and the largest
  /// deviation. With a tolerance of 0, all edges of these faces have as many, and none is told.
  std::pair<vtkIdType, double> Choose(
    const std::vector<unsigned char>& areWanted, double tolerance);

  /// What was chosen, per edge.
  const std::vector<unsigned char>& GetEdgeSteps() const { return this->EdgeSteps; }
  FacePattern GetPattern(int face) const { return this->MakePattern(face, this->GetSteps(face)); }

private:
  using Steps = std::array<int, 3>; // of a face's sorted edges

  FacePattern MakePattern(int face, const Steps& steps) const;
  Steps GetSteps(int face) const;
  int CountParts(int face) const;
  void FindOwnStep(int face, PatternDeviation& deviation);
  void FindOwnSteps(const std::vector<int>& faces);
  int GetNextStep(int step, double deviation) const;
  void ShareOwnSteps(const std::vector<int>& faces);
  std::vector<double> Measure(const std::vector<int>& faces) const;
  bool Raise(const std::vector<int>& faces, const std::vector<double>& deviations);

  const RefinementMesh* Mesh = nullptr;
  const RefinedSurface* Surface = nullptr;
  std::shared_ptr<const PatternFamily> Family;
  int HighestStep = 0;
  int MaximumParts = 1;
  int Texels[2] = { 0, 0 }; // of the displacement's height map
  std::vector<int> FaceEdges;

  double Tolerance = -1.0;
  std::vector<signed char> OwnSteps; // per face; -1 where not known
  std::vector<double> OwnDeviations;
  std::vector<unsigned char> EdgeSteps;
};
}

#endif
