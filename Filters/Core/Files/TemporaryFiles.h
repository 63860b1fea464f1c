// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TemporaryFiles
 * @brief   removes unfinished files when a signal ends the process
 *
 * Private to the modules' own sources.
 */
#ifndef TemporaryFiles_h
#define TemporaryFiles_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>

namespace relevo
{
/**
 * While there is a temporary file, SIGINT, SIGTERM and SIGHUP remove all of them before they end
 * the process. From the first one on, SIGXFSZ is ignored, so that writing fails with an error: a
 * writer may flush what it has long after its file is gone. Only signals with their default action
 * are handled: handlers of the application stay. Safe to use in several threads.
 */
class RELEVOFILTERSCORE_EXPORT TemporaryFiles
{
public:
  struct Entry;

  /// Add the file before it is made. Throws std::bad_alloc.
  static Entry* Add(const std::string& fileName);
  /// Forget the file. It stays where it is.
  static void Forget(Entry* entry);
};
}

#endif
