// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  StageReport
 * @brief   the errors and warnings of a stage, for its mapper to report
 *
 * Stages do not have access to their mapper, so they return messages. Each message is returned
 * once.
 */
#ifndef StageReport_h
#define StageReport_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string> // for messages
#include <vector> // for members

class vtkObject;

namespace relevo
{
struct StageReport
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

  /// Invoke an ErrorEvent or a WarningEvent of the object for each message.
  RELEVOFILTERSCORE_EXPORT void InvokeEvents(vtkObject* object) const;
};
}

#endif
