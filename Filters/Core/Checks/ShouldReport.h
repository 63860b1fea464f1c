// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reports a problem once, not in every frame
 *
 * Private to Relevo's own sources.
 */
#ifndef ShouldReport_h
#define ShouldReport_h

#include <string>

namespace relevo
{
/// Whether a problem differs from the last one and is not empty; it becomes the last one.
inline bool ShouldReport(std::string& last, const std::string& error)
{
  const bool isNew = error != last && !error.empty();
  last = error;
  return isNew;
}
}

#endif
