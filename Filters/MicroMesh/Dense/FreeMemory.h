// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   frees the memory of containers
 */
#ifndef FreeMemory_h
#define FreeMemory_h

namespace relevo
{
/// Free the memory of a container. The assignment of {} to a std::vector keeps it.
template <typename Container>
void FreeMemory(Container& container)
{
  container = Container();
}
}

#endif
