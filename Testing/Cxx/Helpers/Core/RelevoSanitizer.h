// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Tells tests whether the address sanitizer checks the modules. It needs more memory and frees it
// later, and code takes several times as long, so tests repeat less.
#ifndef RelevoSanitizer_h
#define RelevoSanitizer_h

#ifdef RELEVO_HAS_ADDRESS_SANITIZER // by CMake, because tests themselves are not checked
constexpr bool RelevoHasAddressSanitizer = true;
#else
constexpr bool RelevoHasAddressSanitizer = false;
#endif

#endif
