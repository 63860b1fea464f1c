// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the time of the latest change of an object or its parts
 */
#ifndef LatestTime_h
#define LatestTime_h

#include "vtkObject.h"

#include <algorithm>
#include <initializer_list>

namespace relevo
{
/// The latest modification time of an object and its parts. A part may be nullptr.
inline vtkMTimeType GetLatestTime(vtkMTimeType own, std::initializer_list<vtkObject*> parts)
{
  for (vtkObject* part : parts)
  {
    own = part ? std::max(own, part->GetMTime()) : own;
  }
  return own;
}
}

#endif
