// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   sessions: a file, options and a camera, as JSON
 *
 *     {
 *       "version": 1,
 *       "file": "beam.vtu",
 *       "options": { "array": "Stress", "no-legend": true },
 *       "camera": { "position": [0, 0, 5], ... }
 *     }
 *
 * Names of options are those of the command line without hyphens. Files are relative to the folder
 * of the session.
 */
#ifndef SessionFile_h
#define SessionFile_h

#include <array>
#include <map>
#include <optional>
#include <string>

struct SessionCamera
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  std::array<double, 3> ViewUp;
  double ViewAngle = 30.0; // degrees
  double ParallelScale = 1.0;
  bool IsParallel = false;
};

struct ViewerSession
{
  std::string Input;
  // Names with hyphens, and their values. A flag has none.
  std::map<std::string, std::optional<std::string>> Options;
  std::optional<SessionCamera> Camera;
};

/// Reads a session. Throws UsageError with the name of the file. Options are not checked.
ViewerSession ReadSession(const std::string& fileName);

/// Replaces the file when all is written. Throws ViewerError.
void WriteSession(const std::string& fileName, const ViewerSession& session);

#endif
