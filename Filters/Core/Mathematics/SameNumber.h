// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   checks that a private enumeration has the same numbers as a public one
 */
#ifndef SameNumber_h
#define SameNumber_h

namespace relevo
{
template <typename A, typename B>
constexpr bool HaveSameNumber(A a, B b)
{
  return static_cast<int>(a) == static_cast<int>(b);
}
}

#endif
