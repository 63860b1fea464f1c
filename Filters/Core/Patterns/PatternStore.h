// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternStore
 * @brief   a cache of the patterns that were generated or read
 *
 * Patterns never change. They are shared pointers, so a store can be deleted at any time.
 * Thread-safe; no thread waits while another generates a pattern.
 */
#ifndef PatternStore_h
#define PatternStore_h

#include "Patterns/RefinementPattern.h"
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"

#include <array>
#include <map>
#include <memory>
#include <shared_mutex>
#include <vector>

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT PatternStore
{
public:
  using Pattern = std::shared_ptr<const RefinementPattern>;

  PatternStore() = default;

  /// Create a store with these canonical patterns.
  explicit PatternStore(std::vector<RefinementPattern>&& canonical);

  /// Return the shared store, which exists as long as one of its users does.
  static std::shared_ptr<PatternStore> GetShared();

  /// See vtkRefinementPatternTable::GetPatternOfSegments(), for valid numbers.
  Pattern GetCanonical(const std::array<int, 3>& segments);

  /// See MakeNestedPattern().
  Pattern GetNested(const std::array<int, 3>& levels);

  vtkTypeInt64 GetMemorySize() const;

private:
  /// Three numbers of segments, or three levels after a 1.
  using Key = std::array<int, 4>;

  template <typename Make>
  Pattern Get(const Key& key, const Make& make);

  mutable std::shared_mutex Mutex;
  std::map<Key, Pattern> Patterns;
};
}

#endif
