// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes a mesh in the format of its file name
 */
#ifndef ViewerExport_h
#define ViewerExport_h

#include "Files/ExportedMesh.h"

#include <string>
#include <vector>

class ViewerMessages;

/// The supported extensions, with their dots.
std::vector<std::string> GetExportExtensions();

/// Whether positions are floats in the format, or in most programs that read it.
bool HasFloats(const std::string& fileName);

/// Whether the format has a picture.
bool CanHavePicture(const std::string& fileName);

/// The other files that a mesh with a picture consists of.
std::vector<std::string> GetCompanions(const std::string& fileName);

/// Throws ViewerError if a file cannot be written.
void WriteMesh(const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages);

#endif
