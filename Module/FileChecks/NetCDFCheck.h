// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks that a classic netCDF file, such as most Exodus files, is complete
 */
#ifndef NetCDFCheck_h
#define NetCDFCheck_h

#include <string>

/// Throws FileError for a truncated file: the netCDF library would read zeros beyond its end.
/// Other formats, such as netCDF-4, pass.
void CheckNetCDF(const std::string& fileName);

#endif
