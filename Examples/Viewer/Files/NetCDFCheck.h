// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether a classic netCDF file, such as most Exodus files, has all that its header says
 */
#ifndef NetCDFCheck_h
#define NetCDFCheck_h

#include <string>

/// Throws ViewerError: the netCDF library reads zeros beyond the end of a file. Files of other
/// formats pass, such as netCDF-4.
void CheckNetCDF(const std::string& fileName);

#endif
