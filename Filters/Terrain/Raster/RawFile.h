// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   detection of truncated TIFF files and raw files, which a separate header describes
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef RawFile_h
#define RawFile_h

#include <gdal.h>

#include <string>

namespace relevo
{
/**
 * Describes how much is missing at the end of a TIFF file or a raw file. Returns "" if nothing is
 * missing or the dataset is another file. GDAL replaces missing data by zeros in formats that may
 * be sparse (ENVI). Of a large TIFF file, some blocks of each level are looked at.
 */
std::string FindTruncation(GDALDatasetH dataset);
}

#endif
