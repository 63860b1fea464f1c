// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   files of samples without a structure of their own, described by a header beside them
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
 */
#ifndef RawFile_h
#define RawFile_h

#include <gdal.h>

#include <string>

namespace relevo
{
/**
 * How much is missing at the end of a raw file, in words; empty where nothing is, or the dataset is
 * no raw file. GDAL takes what is missing for zeros where a format may be sparse (ENVI).
 */
std::string FindTruncation(GDALDatasetH dataset);
}

#endif
