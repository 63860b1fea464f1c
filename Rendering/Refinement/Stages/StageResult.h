// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  StageResult
 * @brief   the result of a mapper's stage: whether the frame can continue, and what to report
 *
 * Private to the module.
 */
#ifndef StageResult_h
#define StageResult_h

#include "Checks/StageReport.h"

namespace relevo
{
struct StageResult : StageReport
{
  bool IsValid = true;
};
}

#endif
