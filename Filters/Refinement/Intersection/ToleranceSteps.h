// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ToleranceSteps
 * @brief   chooses the numbers of segments of edges so that faces are within a tolerance of their
 * surface
 *
 * For each face, the lowest sufficient step for three equal edges is measured once and cached. An
 * edge gets the largest step of its requested faces. If the edges of a face differ, its triangles
 * are different and can be longer. The lowest steps then increase until the triangles are within
 * the tolerance too. The steps therefore depend only on the requested faces, not on previous calls.
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
  /// Set a new surface and the edges of its faces. All of it must outlive this object.
  void Take(const RefinementMesh& mesh, const RefinedSurface& surface,
    vtkAdaptiveRefinement* recipe, std::vector<int> faceEdges, int numberOfEdges);

  /// Choose steps for the faces marked in `areWanted`, one byte per face. Returns the number of
  /// faces that deviate by more than the tolerance at the highest number of segments, and the
  /// largest deviation. With a tolerance of 0, all edges of these faces get the highest number, and
  /// the result is 0.
  std::pair<vtkIdType, double> Choose(
    const std::vector<unsigned char>& areWanted, double tolerance);

  /// The chosen step per edge.
  const std::vector<unsigned char>& GetEdgeSteps() const { return this->EdgeSteps; }
  FacePattern GetPattern(int face) const { return this->MakePattern(face, this->GetSteps(face)); }

private:
  using Steps = std::array<int, 3>; // for a face's sorted edges

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
  std::vector<signed char> OwnSteps; // per face; -1 if not known
  std::vector<double> OwnDeviations;
  std::vector<unsigned char> EdgeSteps;
};
}

#endif
