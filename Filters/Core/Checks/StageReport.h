// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  StageReport
 * @brief   the errors and warnings that a stage has its mapper report
 *
 * A stage does not see its mapper, so it returns messages, each of them once. Private to the
 * modules.
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

  /// Invoke an ErrorEvent or a WarningEvent of the object for each of them.
  RELEVOFILTERSCORE_EXPORT void InvokeEvents(vtkObject* object) const;
};
}

#endif
