// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A virtual file system of GDAL whose reads wait until the test lets them go on.
#ifndef RelevoHangingFiles_h
#define RelevoHangingFiles_h

class RelevoHangingFiles
{
public:
  // The name of a file follows.
  static const char* const Prefix;

  // Make the file system known to GDAL, once.
  static void Install();

  // While reads hang, they wait for Resume().
  static void Hang();
  static void Resume();

  // The number of reads that wait.
  static int GetNumberOfHanging();
  // Wait until a read hangs.
  static void WaitForHanging();
  // Wait until all files are closed.
  static void WaitForClosed();
};

#endif
