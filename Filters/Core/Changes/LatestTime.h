// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   when something or one of its parts last changed
 */
#ifndef LatestTime_h
#define LatestTime_h

#include "vtkObject.h"

#include <algorithm>
#include <initializer_list>

namespace relevo
{
/// The latest of an object's own time and its parts'; a part may be nullptr.
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
