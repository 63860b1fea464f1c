// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Points/MergedPoints.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace
{
// Points are first sorted into buckets by their hash, so that buckets can be searched in parallel,
// each with a hash table that fits into the cache.
constexpr int BucketBits = 8;
constexpr int NumberOfBuckets = 1 << BucketBits;

using Coordinates = std::array<double, 3>;

int BucketOf(std::uint64_t hash)
{
  return static_cast<int>(hash >> (64 - BucketBits));
}

std::uint64_t Hash(const Coordinates& x)
{
  std::uint64_t hash = 0;
  for (double coordinate : x)
  {
    coordinate += 0.0; // -0 becomes 0
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    // Stafford's variant 13 of the 64-bit finaliser of MurmurHash3, chained.
    hash ^= bits + 0x9e3779b97f4a7c15ull;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ull;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebull;
    hash ^= hash >> 31;
  }
  return hash;
}

struct PlacesWorker
{
  std::vector<vtkIdType> MergedPoints;
  bool Coincident = false;

  template <typename ArrayT>
  void operator()(ArrayT* array)
  {
    const auto tuples = vtk::DataArrayTupleRange<3>(array);
    const vtkIdType n = tuples.size();
    const auto at = [&tuples](vtkIdType id)
    {
      const auto tuple = tuples[id];
      return Coordinates{ static_cast<double>(tuple[0]), static_cast<double>(tuple[1]),
        static_cast<double>(tuple[2]) };
    };

    std::vector<std::uint64_t> hashes(n);
    vtkSMPTools::For(0, n,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType id = begin; id < end; ++id)
        {
          hashes[id] = Hash(at(id));
        }
      });

    // Counting sort into buckets. Ids are ascending within each.
    std::array<vtkIdType, NumberOfBuckets + 1> starts{};
    for (std::uint64_t hash : hashes)
    {
      ++starts[BucketOf(hash) + 1];
    }
    for (int bucket = 0; bucket < NumberOfBuckets; ++bucket)
    {
      starts[bucket + 1] += starts[bucket];
    }
    std::vector<vtkIdType> order(n);
    auto next = starts;
    for (vtkIdType id = 0; id < n; ++id)
    {
      order[next[BucketOf(hashes[id])]++] = id;
    }

    this->MergedPoints.resize(n);
    std::atomic<bool> coincident(false);
    vtkSMPThreadLocal<std::vector<vtkIdType>> tables;
    vtkSMPTools::For(0, NumberOfBuckets,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<vtkIdType>& table = tables.Local();
        for (vtkIdType bucket = begin; bucket < end; ++bucket)
        {
          std::size_t size = 2;
          while (size < 2 * static_cast<std::size_t>(starts[bucket + 1] - starts[bucket]))
          {
            size *= 2;
          }
          table.assign(size, -1);
          for (vtkIdType i = starts[bucket]; i < starts[bucket + 1]; ++i)
          {
            const vtkIdType id = order[i];
            const Coordinates x = at(id);
            this->MergedPoints[id] = id;
            if (std::isnan(x[0]) || std::isnan(x[1]) || std::isnan(x[2]))
            {
              continue;
            }
            std::size_t slot = hashes[id] & (size - 1);
            while (table[slot] >= 0 && at(table[slot]) != x)
            {
              slot = (slot + 1) & (size - 1);
            }
            if (table[slot] < 0)
            {
              table[slot] = id;
            }
            else
            {
              this->MergedPoints[id] = table[slot];
              coincident = true;
            }
          }
        }
      });
    this->Coincident = coincident;
  }
};
}

namespace relevo
{
std::vector<vtkIdType> ComputeMergedPoints(vtkPoints* points)
{
  if (!points || points->GetNumberOfPoints() < 2)
  {
    return {};
  }
  PlacesWorker worker;
  using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
  if (!Dispatcher::Execute(points->GetData(), worker))
  {
    worker(points->GetData());
  }
  return worker.Coincident ? std::move(worker.MergedPoints) : std::vector<vtkIdType>();
}

std::uint64_t HashPoint(const double x[3])
{
  return Hash({ x[0], x[1], x[2] });
}

void UniteTags(const std::vector<vtkIdType>& mergedPoints, float* tags)
{
  const vtkIdType n = static_cast<vtkIdType>(mergedPoints.size());
  for (vtkIdType id = 0; id < n; ++id)
  {
    tags[mergedPoints[id]] = std::max(tags[mergedPoints[id]], tags[id]);
  }
  for (vtkIdType id = 0; id < n; ++id)
  {
    tags[id] = tags[mergedPoints[id]];
  }
}
}
