// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternLibrary
 * @brief   hands out patterns by family
 *
 * The families of one library share their patterns, and all who use a library share its families.
 * Libraries may have one PatternStore: they too share their patterns. A
 * library never changes, except that it makes patterns when they are first asked for: a
 * vtkRefinementPatternTable that reads a file takes another library. Patterns and families belong
 * to all who have a pointer to them, and outlive the library. Safe to call from several threads.
 */
#ifndef PatternLibrary_h
#define PatternLibrary_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkTimeStamp.h"            // for MakeTime

#include <array>   // for members
#include <cstddef> // for size_t
#include <memory>  // for members
#include <mutex>   // for std::once_flag
#include <string>  // for members
#include <vector>  // for constructor

namespace relevo
{
struct RefinementPattern;
class PatternFamily;
class PatternStore;
class RELEVOFILTERSCORE_EXPORT PatternLibrary
{
public:
  using Pattern = std::shared_ptr<const RefinementPattern>;

  /// The patterns that RefinementPatternGenerator and NestedPattern make, in a store of its own or
  /// one that others have too.
  PatternLibrary();
  explicit PatternLibrary(std::shared_ptr<PatternStore> store);

  /// Those of a file: canonical patterns of all levels up to the highest.
  PatternLibrary(
    std::string fileName, int highestLevel, std::vector<RefinementPattern>&& canonical);

  ~PatternLibrary();
  PatternLibrary(const PatternLibrary&) = delete;
  void operator=(const PatternLibrary&) = delete;

  /// When the library was made: no other has the same time.
  vtkMTimeType GetMTime() const { return this->MakeTime; }

  /// The file that the patterns were read from; empty for none.
  const std::string& GetFileName() const { return this->FileName; }

  /// The highest level of an edge that all families have.
  int GetHighestLevel() const { return this->HighestLevel; }

  enum Families
  {
    /// 2^level segments for levels up to the highest; canonical patterns, permuted.
    POWERS_OF_TWO,
    /// 1 to 16 segments, then 9 to 16 times 2, 4 and 8; canonical patterns, permuted.
    WHOLE_NUMBERS,
    /// 2^level segments; patterns of the sorted corners whose vertices morph (NestedPattern).
    NESTED
  };

  /// Why the library lacks a family, as a clause that says what to do; empty if it has it. There
  /// are always POWERS_OF_TWO.
  std::string GetError(Families family) const;

  /// nullptr where there is an obstacle.
  std::shared_ptr<const PatternFamily> GetFamily(Families family) const;

  /// The canonical pattern with segments 128 >= n1 >= n2 >= n3 >= 1 on its edges.
  Pattern GetPatternOfSegments(int n1, int n2, int n3) const;

  /// Bytes of the patterns made so far, all that are in the store.
  vtkTypeInt64 GetMemorySize() const;

private:
  std::shared_ptr<const PatternFamily> MakeFamily(Families family) const;

  static constexpr std::size_t NumberOfFamilies = 3;

  std::string FileName; // empty for none
  int HighestLevel;
  std::shared_ptr<PatternStore> Store;
  mutable std::array<std::once_flag, NumberOfFamilies> Flags;
  mutable std::array<std::shared_ptr<const PatternFamily>, NumberOfFamilies> Made;
  vtkTimeStamp MakeTime;
};
}

#endif
