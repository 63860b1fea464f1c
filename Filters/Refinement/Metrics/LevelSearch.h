// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LevelSearch
 * @brief   searches the tags for which displaced faces deviate by no more than their limits
 *
 * The variables are the tags of edges, or those of merged points, whose means are the tags of
 * edges. All start with one segment. While a face deviates too much, the tags of its edges increase
 * where the edges deviate, or else its lowest tags. The result depends only on the faces and their
 * limits, not on previous searches.
 */
#ifndef LevelSearch_h
#define LevelSearch_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <array>   // for variables of faces
#include <cstddef> // for size_t
#include <vector>  // for members

namespace relevo
{
class DisplacedFaces;
class PatternFamily;
class SurfaceEdges;

class RELEVOFILTERSREFINEMENT_EXPORT LevelSearch
{
public:
  /// Search the tags of edges, in the order of `edges`.
  void UseEdges(const DisplacedFaces& faces, const SurfaceEdges& edges);
  /// Search the tags of merged points.
  void UsePoints(const DisplacedFaces& faces, std::size_t numberOfPoints);

  /// Whether edges with one face have the highest level, so that meshes with a common border match.
  void SetFixedBorder(bool isFixed) { this->HasFixedBorder = isFixed; }

  /**
   * Search with one limit per face, in units of the mesh. No edge gets more segments than
   * 2^highestLevel.
   */
  void Run(DisplacedFaces& faces, const PatternFamily& family, const std::vector<double>& limits,
    int highestLevel);

  /**
   * Return the tag of a variable. With the highest number of segments, it continues as if the error
   * decreased quadratically.
   */
  float GetTag(int variable) const;

private:
  using Variables = std::array<int, 3>;

  void SetVariables(std::size_t number);
  void FixBorder();
  float GetTagOfStep(int step) const;
  std::array<float, 3> GetTags(int face) const;
  bool CanRaise(int variable) const;
  void Raise(int variable, double excess);
  void RaiseLowest(const int* variables, std::size_t number, double excess);
  void RaiseFace(int face);
  void MeasureFaces(DisplacedFaces& faces, const std::vector<int>& which);
  std::vector<int> FindFacesOfRaised();

  bool ArePoints = false;
  bool HasFixedBorder = false;
  std::vector<Variables> FaceVariables;
  std::vector<int> Starts; // index into Uses per variable
  std::vector<int> Uses;   // faces
  std::vector<char> AreBorder;

  // During a search:
  const PatternFamily* Family = nullptr;
  const std::vector<double>* Limits = nullptr;
  int HighestStep = 0;
  std::vector<int> VariableSteps;
  std::vector<int> NextSteps;
  std::vector<int> Raised;
  std::vector<std::array<float, 4>> Deviations; // on the edges and inside
  std::vector<float> StepTags;                  // per step, at most the highest level
};
}

#endif
