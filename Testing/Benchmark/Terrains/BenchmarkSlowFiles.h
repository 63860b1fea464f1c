// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkSlowFiles
 * @brief   a virtual file system of GDAL whose reads take time
 */
#ifndef BenchmarkSlowFiles_h
#define BenchmarkSlowFiles_h

class BenchmarkSlowFiles
{
public:
  /// The name of a file follows.
  static const char* const Prefix;

  /// Make the file system known to GDAL.
  static void Install();

  /// Set the time that each read takes, in milliseconds; 0 by default.
  static void SetDelay(int milliseconds);
};

#endif
