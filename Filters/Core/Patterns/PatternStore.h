// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternStore
 * @brief   the patterns that have been made or read so far
 *
 * Patterns never change. Who has a pointer to one owns it too, so a store may go at any time. Safe
 * to call from several threads; none waits while another makes a pattern.
 *
 * Private to the module's own sources.
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

  /// A store that has these canonical patterns.
  explicit PatternStore(std::vector<RefinementPattern>&& canonical);

  /// The store of all who ask for it, kept as long as one of them keeps it.
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
