// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RelevoFuzzAssert_h
#define RelevoFuzzAssert_h

#include <cstdlib>
#include <iostream>

// Ends a fuzz target, with a message, if a promise is broken.
#define FUZZ_ASSERT(condition)                                                                    \
  do                                                                                              \
  {                                                                                               \
    if (!(condition))                                                                             \
    {                                                                                             \
      std::cerr << __FILE__ << ":" << __LINE__ << ": " << #condition << " is false" << std::endl; \
      std::abort();                                                                               \
    }                                                                                             \
  } while (false)

#endif
