// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   an error that some processes have, for the first process to report
 *
 * Private to ParaView's modules.
 */
#ifndef ProcessError_h
#define ProcessError_h

#include "RelevoParaViewFiltersModule.h" // for export macro

#include <string>

class vtkMultiProcessController;

namespace relevo
{
/**
 * Return the error of the first process that has one, or "". If other processes have none, the
 * message begins with the number of the process. Collective; without a controller, the error is
 * returned.
 */
RELEVOPARAVIEWFILTERS_EXPORT std::string FindProcessError(
  const std::string& own, vtkMultiProcessController* controller);

/// Return whether this is the process whose messages a client shows.
RELEVOPARAVIEWFILTERS_EXPORT bool IsReportingProcess(vtkMultiProcessController* controller);
}

#endif
