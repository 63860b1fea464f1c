// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICField
 * @brief   what there is to show of the vectors of all blocks
 *
 * Private to the module's own sources.
 */
#ifndef LICField_h
#define LICField_h

#include "Changes/Dependencies.h"
#include "Passes/LICArray.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace relevo
{
struct LICFieldFacts
{
  bool HasFaces = false;
  bool HasArray = false;
  double Longest = -1.0; // negative if there is none
  std::string Problem;   // of an array
};

class LICField
{
public:
  struct Input
  {
    std::vector<vtkPolyData*> Meshes;
    vtkMTimeType BuildTime;
    double NoDataMagnitude;
    std::function<LICArray(vtkPolyData*)> FindArray;
    /// The array of the name that is wanted, if the association is another; or "".
    std::function<std::string(vtkPolyData*)> DescribeMisplaced;
  };

  /// Look at the meshes again if something has changed.
  void Update(const Input& input);
  /// Of this process.
  const LICFieldFacts& GetOwn() const { return this->Own; }

  /// Of all processes that draw the picture.
  void SetAll(const LICFieldFacts& facts) { this->All = facts; }
  double GetLongest() const { return this->All.Longest; }

  /// Why no process can show streaks, as a sentence; or "".
  std::string FindProblem() const;

private:
  Dependencies Sources;
  LICFieldFacts Own;
  LICFieldFacts All;
  std::string Misplaced;
};
}

#endif
