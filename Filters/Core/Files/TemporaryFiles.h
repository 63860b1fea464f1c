// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TemporaryFiles
 * @brief   removes unfinished files when a signal ends the process
 */
#ifndef TemporaryFiles_h
#define TemporaryFiles_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>

namespace relevo
{
/**
 * While there are temporary files, SIGINT, SIGTERM and SIGHUP remove them before they end the
 * process. Once a file has been added, SIGXFSZ is ignored, so that writing fails with an error: a
 * writer may flush data long after its file is gone. Only signals with their default action are
 * handled, so that the application's handlers remain. Thread-safe.
 */
class RELEVOFILTERSCORE_EXPORT TemporaryFiles
{
public:
  struct Entry;

  /// Add a file before it is created. Throws std::bad_alloc.
  static Entry* Add(const std::string& fileName);
  /// Stop tracking the file. It is not removed.
  static void Forget(Entry* entry);
};
}

#endif
