// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Limits memory, so that larger allocations fail.
#ifndef RelevoMemory_h
#define RelevoMemory_h

#include "RelevoSanitizer.h"

#ifdef __linux__
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

// Active during its lifetime, if Works() returns true.
class RelevoMemoryLimit
{
public:
  // Allows this many bytes in addition to the memory in use.
  explicit RelevoMemoryLimit(long bytes)
  {
#ifdef __linux__
    malloc_trim(0);
    mallopt(M_MMAP_THRESHOLD, 16384); // returns freed memory to the system at once
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &this->Before);
    rlimit limit = this->Before;
    limit.rlim_cur = static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE) + bytes);
    setrlimit(RLIMIT_AS, &limit);
#else
    static_cast<void>(bytes);
#endif
  }
  ~RelevoMemoryLimit()
  {
#ifdef __linux__
    setrlimit(RLIMIT_AS, &this->Before);
#endif
  }
  RelevoMemoryLimit(const RelevoMemoryLimit&) = delete;
  void operator=(const RelevoMemoryLimit&) = delete;

  // Returns false with sanitizers, which need additional memory.
  static constexpr bool Works()
  {
#ifdef __linux__
    return !RelevoHasAddressSanitizer;
#else
    return false;
#endif
  }

private:
#ifdef __linux__
  rlimit Before;
#endif
};

#endif
