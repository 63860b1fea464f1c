// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the rank that speaks for all
 *
 * Private to the module.
 */
#ifndef FirstRank_h
#define FirstRank_h

#include "vtkMultiProcessController.h"

namespace relevo
{
/// Return whether this is rank 0 of the server, or the only process.
inline bool IsFirstRank()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}
}

#endif
