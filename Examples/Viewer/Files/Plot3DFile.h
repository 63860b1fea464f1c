// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   binary grids of PLOT3D, which have no common extension
 */
#ifndef Plot3DFile_h
#define Plot3DFile_h

#include <memory>
#include <string>

class ResultReader;
class ViewerMessages;

/// Whether a file is a binary 3D grid of PLOT3D: it is exactly as long as the dimensions at its
/// beginning require, in either byte order, of one block or several, with or without the markers of
/// Fortran and blanks.
bool IsPlot3D(const std::string& fileName);

/// Returns a reader for a grid and its solution. That of NAME.xyz or NAME.x is NAME.q, and that of
/// NAMExyz.bin is NAMEq.bin.
std::unique_ptr<ResultReader> OpenPlot3D(const std::string& fileName, ViewerMessages& messages);

#endif
