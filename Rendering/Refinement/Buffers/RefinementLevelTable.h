// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementLevelTable
 * @brief   the default lookup table for levels, patterns or tags
 */
#ifndef RefinementLevelTable_h
#define RefinementLevelTable_h

#include "Changes/Dependencies.h"            // for members
#include "Shaders/RefinementShaderOptions.h" // for RefinementColorMode
#include "vtkNew.h"                          // for Table

class vtkLookupTable;

namespace relevo
{
struct RefinementPattern;
class SegmentSteps;

class RefinementLevelTable
{
public:
  RefinementLevelTable();
  ~RefinementLevelTable();

  /**
   * Return the table for a RefinementColorMode: a colour and an annotation per level or pattern, or
   * a range for tags.
   */
  vtkLookupTable* Get(int mode, bool wholeNumbers, int maximumLevel);

  /**
   * Return the value that a table maps for a face of this pattern: its highest level, or the
   * pattern's index.
   */
  static double GetValue(int mode, bool wholeNumbers, const RefinementPattern& pattern);

  /// Return the lowest level whose 2^level segments are at least this number.
  static int GetLevel(int segments);

private:
  void MakeLevels(int maximumLevel);
  void MakePatterns(const SegmentSteps& steps, int maximumLevel);
  void MakeTags(int maximumLevel);

  vtkNew<vtkLookupTable> Table;
  Dependencies TableDependencies;
};
}

#endif
