// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICVectorField
 * @brief   the properties of the vectors of all blocks
 *
 * Private to the module's own sources.
 */
#ifndef LICVectorField_h
#define LICVectorField_h

#include "Changes/Dependencies.h"
#include "Passes/LICArray.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace relevo
{
struct LICVectorFacts
{
  bool HasFaces = false;
  bool HasArray = false;
  double Longest = -1.0; // negative if there is none
  std::string Error;     // error of an array
};

class LICVectorField
{
public:
  struct Input
  {
    std::vector<vtkPolyData*> Meshes;
    vtkMTimeType BuildTime;
    double NoDataMagnitude;
    std::function<LICArray(vtkPolyData*)> FindArray;
    /// Returns the array with the requested name but another association, or "".
    std::function<std::string(vtkPolyData*)> DescribeMisplaced;
  };

  /// Check the meshes again if something has changed.
  void Update(const Input& input);
  /// Return the facts of this process.
  const LICVectorFacts& GetOwn() const { return this->Own; }

  /// Set the facts of all processes that draw the image.
  void SetAll(const LICVectorFacts& facts) { this->All = facts; }
  double GetLongest() const { return this->All.Longest; }

  /// Return why no process can show streaks, as a sentence; or "".
  std::string FindError() const;

private:
  Dependencies Sources;
  LICVectorFacts Own;
  LICVectorFacts All;
  std::string Misplaced;
};
}

#endif
