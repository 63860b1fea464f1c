// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes a mesh in the format that its file's name asks for
 */
#ifndef ViewerExport_h
#define ViewerExport_h

#include <string>
#include <vector>

class vtkPolyData;
class ViewerMessages;

/// The extensions that there are writers for, with their dots.
std::vector<std::string> GetExportExtensions();

/// Throws ViewerError.
void WriteMesh(vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages);

#endif
