// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Takes memory away, so that what needs more than so many bytes fails.
#ifndef RelevoMemory_h
#define RelevoMemory_h

#ifdef __linux__
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

// As long as it lives, and only where it can: see Works().
class RelevoMemoryLimit
{
public:
  // Beyond what the process has.
  explicit RelevoMemoryLimit(long bytes)
  {
#ifdef __linux__
    malloc_trim(0);
    mallopt(M_MMAP_THRESHOLD, 16384); // what is freed goes back at once
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

  // Not with sanitizers, which need room of their own.
  static constexpr bool Works()
  {
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
    return true;
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
