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

#include "ProcessError.h"
#include "vtkMultiProcessController.h"

namespace relevo
{
/// Return whether this is rank 0 of the server, or the only process.
inline bool IsFirstRank()
{
  return IsReportingProcess(vtkMultiProcessController::GetGlobalController());
}
}

#endif
