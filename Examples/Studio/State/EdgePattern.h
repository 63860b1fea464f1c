// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EdgePattern
 * @brief   the pattern of a triangle whose edges have given levels
 */
#ifndef EdgePattern_h
#define EdgePattern_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class ViewerMessages;
class vtkPolyData;
class vtkRefinementPatternTable;

/// A point in an equilateral triangle with sides of length 1. Its first edge is at the bottom.
using PatternPlace = std::array<double, 2>;

class EdgePattern
{
public:
  EdgePattern();
  ~EdgePattern();

  /// Sets the levels of the edges from a text such as "2,1,0". Throws ViewerError, without a
  /// change, if they are not three whole numbers from 0 to 7.
  void Set(const std::string& levels);

  const std::array<int, 3>& GetLevels() const { return this->Levels; }
  /// The levels of the stored pattern that is permuted, in descending order.
  const std::array<int, 3>& GetBase() const { return this->Base; }
  /// The number of the permutation (Lenz 2009).
  int GetLambda() const { return this->Lambda; }

  const std::vector<PatternPlace>& GetPlaces() const { return this->Places; }
  const std::vector<std::array<int, 3>>& GetTriangles() const { return this->Triangles; }
  /// In degrees.
  double GetSmallestAngle() const { return this->SmallestAngle; }

  /// Writes the pattern as an equilateral triangle in the plane z = 0. Throws ViewerError.
  void Save(const std::string& fileName, ViewerMessages& messages) const;
  /// Writes all patterns up to the highest level of the edges: see
  /// vtkRefinementPatternTable::Write(). Throws ViewerError.
  void SaveTable(const std::string& fileName, ViewerMessages& messages);

private:
  void Measure(vtkPolyData* pattern);

  vtkNew<vtkRefinementPatternTable> Table;
  std::array<int, 3> Levels = { { 0, 0, 0 } };
  std::array<int, 3> Base = { { 0, 0, 0 } };
  int Lambda = 0;
  std::vector<PatternPlace> Places;
  std::vector<std::array<int, 3>> Triangles;
  double SmallestAngle = 60.0;
};

#endif
