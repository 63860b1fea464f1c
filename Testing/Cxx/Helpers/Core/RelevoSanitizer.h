// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Tells tests of memory whether the address sanitizer, which needs more and frees it later, is on.
#ifndef RelevoSanitizer_h
#define RelevoSanitizer_h

#ifdef __SANITIZE_ADDRESS__ // g++
constexpr bool RelevoHasAddressSanitizer = true;
#elif defined(__has_feature) // clang++
constexpr bool RelevoHasAddressSanitizer = __has_feature(address_sanitizer);
#else
constexpr bool RelevoHasAddressSanitizer = false;
#endif

#endif
