// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds truncated rasters that GDAL accepts
 */
#ifndef RasterEnd_h
#define RasterEnd_h

#include <string>

class ViewerMessages;

/// Checks rasters as CheckFileEnd() does. The error names the file. Missing files pass.
void CheckRasterEnd(const std::string& fileName, ViewerMessages& messages);

#endif
