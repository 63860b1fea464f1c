// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternLibrary
 * @brief   provides patterns by family
 *
 * The families of one library share its patterns. Libraries with the same PatternStore share its
 * patterns too. A library never changes, except that it generates patterns on first use. A
 * vtkRefinementPatternTable that reads a file creates a new library. Patterns and families are
 * shared pointers and outlive the library. Thread-safe.
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

  /// Create a library of the patterns of RefinementPatternGenerator and NestedPattern, in a
  /// separate or a shared store.
  PatternLibrary();
  explicit PatternLibrary(std::shared_ptr<PatternStore> store);

  /// Create a library of patterns from a file: the canonical patterns of all levels up to the
  /// highest.
  PatternLibrary(
    std::string fileName, int highestLevel, std::vector<RefinementPattern>&& canonical);

  ~PatternLibrary();
  PatternLibrary(const PatternLibrary&) = delete;
  void operator=(const PatternLibrary&) = delete;

  /// The time when the library was created, which is unique.
  vtkMTimeType GetMTime() const { return this->MakeTime; }

  /// The file that the patterns were read from, or empty.
  const std::string& GetFileName() const { return this->FileName; }

  /// The highest level of an edge that all families have.
  int GetHighestLevel() const { return this->HighestLevel; }

  enum Families
  {
    /// 2^level segments for levels up to the highest; canonical patterns, permuted.
    POWERS_OF_TWO,
    /// 1 to 16 segments, then 9 to 16 times 2, 4 and 8; canonical patterns, permuted.
    WHOLE_NUMBERS,
    /// 2^level segments; patterns for sorted corners whose vertices morph (NestedPattern).
    NESTED
  };

  /// Return why a family is not available, as a clause with advice, or an empty string.
  /// POWERS_OF_TWO is always available.
  std::string GetError(Families family) const;

  /// Return a family, or nullptr if it is not available.
  std::shared_ptr<const PatternFamily> GetFamily(Families family) const;

  /// Return the canonical pattern with segments 128 >= n1 >= n2 >= n3 >= 1 on its edges.
  Pattern GetPatternOfSegments(int n1, int n2, int n3) const;

  /// The memory of all patterns in the store, in bytes.
  vtkTypeInt64 GetMemorySize() const;

private:
  std::shared_ptr<const PatternFamily> MakeFamily(Families family) const;

  static constexpr std::size_t NumberOfFamilies = 3;

  std::string FileName; // empty if there is none
  int HighestLevel;
  std::shared_ptr<PatternStore> Store;
  mutable std::array<std::once_flag, NumberOfFamilies> Flags;
  mutable std::array<std::shared_ptr<const PatternFamily>, NumberOfFamilies> Made;
  vtkTimeStamp MakeTime;
};
}

#endif
