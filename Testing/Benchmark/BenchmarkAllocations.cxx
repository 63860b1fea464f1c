// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Replaces the operators new and delete, which shared libraries use too.
#include "BenchmarkAllocations.h"

#include <limits>

#ifdef __linux__
#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace
{
std::atomic<bool> IsCounting(false);
std::atomic<long long> Current(0);
std::atomic<long long> Peak(0);

void* Allocate(std::size_t size)
{
  void* memory = std::malloc(size > 0 ? size : 1);
  if (memory && IsCounting)
  {
    const long long now = Current += static_cast<long long>(malloc_usable_size(memory));
    long long peak = Peak;
    while (now > peak && !Peak.compare_exchange_weak(peak, now))
    {
    }
  }
  return memory;
}

void Free(void* memory)
{
  if (memory && IsCounting)
  {
    Current -= static_cast<long long>(malloc_usable_size(memory));
  }
  std::free(memory);
}
}

void* operator new(std::size_t size)
{
  void* memory = Allocate(size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void* operator new[](std::size_t size)
{
  return operator new(size);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return Allocate(size);
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return Allocate(size);
}

void operator delete(void* memory) noexcept
{
  Free(memory);
}

void operator delete[](void* memory) noexcept
{
  Free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  Free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  Free(memory);
}

AllocatedMemory GetAllocatedMemory()
{
  return { static_cast<double>(Current), static_cast<double>(Peak) };
}

void CountAllocatedMemory()
{
  IsCounting = true;
}
#else
AllocatedMemory GetAllocatedMemory()
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  return { unknown, unknown };
}

void CountAllocatedMemory()
{
}
#endif
