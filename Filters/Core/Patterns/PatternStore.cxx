// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternStore.h"

#include "Patterns/NestedPattern.h"
#include "Patterns/RefinementPatternGenerator.h"

#include <cstddef>
#include <mutex>
#include <utility>

namespace relevo
{
PatternStore::PatternStore(std::vector<RefinementPattern>&& canonical)
{
  for (RefinementPattern& pattern : canonical)
  {
    const int* n = pattern.Segments;
    const Key key = { 0, n[0], n[1], n[2] };
    this->Patterns[key] = std::make_shared<const RefinementPattern>(std::move(pattern));
  }
}

std::shared_ptr<PatternStore> PatternStore::GetShared()
{
  static std::mutex mutex;
  static std::weak_ptr<PatternStore> shared;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<PatternStore> store = shared.lock();
  if (!store)
  {
    store = std::make_shared<PatternStore>();
    shared = store;
  }
  return store;
}

template <typename Make>
PatternStore::Pattern PatternStore::Get(const Key& key, const Make& make)
{
  {
    const std::shared_lock<std::shared_mutex> lock(this->Mutex);
    const auto found = this->Patterns.find(key);
    if (found != this->Patterns.end())
    {
      return found->second;
    }
  }
  const auto made = std::make_shared<const RefinementPattern>(make());
  // If several threads have generated it, the first one is stored.
  const std::unique_lock<std::shared_mutex> lock(this->Mutex);
  return this->Patterns.emplace(key, made).first->second;
}

PatternStore::Pattern PatternStore::GetCanonical(const std::array<int, 3>& segments)
{
  const auto& n = segments;
  return this->Get({ 0, n[0], n[1], n[2] }, [&n] { return GeneratePattern(n[0], n[1], n[2]); });
}

PatternStore::Pattern PatternStore::GetNested(const std::array<int, 3>& levels)
{
  return this->Get(
    { 1, levels[0], levels[1], levels[2] }, [&levels] { return MakeNestedPattern(levels); });
}

vtkTypeInt64 PatternStore::GetMemorySize() const
{
  const std::shared_lock<std::shared_mutex> lock(this->Mutex);
  std::size_t size = 0;
  for (const auto& entry : this->Patterns)
  {
    const RefinementPattern& pattern = *entry.second;
    size += sizeof(pattern) + pattern.Vertices.capacity() * sizeof(float) +
      (pattern.Triangles.capacity() + pattern.Lines.capacity()) * sizeof(unsigned int);
  }
  return static_cast<vtkTypeInt64>(size);
}
}
