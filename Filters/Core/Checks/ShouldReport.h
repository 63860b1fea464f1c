// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reports a problem once instead of in each frame
 */
#ifndef ShouldReport_h
#define ShouldReport_h

#include <string>

namespace relevo
{
/// Whether a problem is not empty and differs from the last one, which it then replaces.
inline bool ShouldReport(std::string& last, const std::string& error)
{
  const bool isNew = error != last && !error.empty();
  last = error;
  return isNew;
}
}

#endif
