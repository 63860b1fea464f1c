// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the formats of meshes, and their readers
 */
#ifndef ResultFormats_h
#define ResultFormats_h

#include "Files/ResultReader.h"

#include <memory>
#include <string>

class ViewerMessages;

/// Whether the name has the extension of a mesh format, even if this version of VTK cannot read it.
bool IsMeshFile(const std::string& fileName);

/// The supported formats of all meshes, as in ".ply, .stl or .vtp files".
std::string GetMeshFormats();

/// The formats that can contain 3D cells.
std::string GetVolumeFormats();

/// Whether a format can contain 3D cells.
bool IsVolumeFile(const std::string& fileName);

/// Whether the file may be empty, because the data is in the folders beside it (OpenFOAM).
bool IsMarkerFile(const std::string& fileName);

/// Advice, as the end of a sentence, for a file that is not a mesh by its extension: the formats of
/// meshes, or "" if the extension is that of a raster.
std::string AdviseFormat(const std::string& fileName, const std::string& formats);

/// Returns the reader for a mesh file. Throws ViewerError if this version of VTK has none.
std::unique_ptr<ResultReader> MakeResultReader(
  const std::string& fileName, ViewerMessages& messages);

#endif
