// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes a mesh in the format of its file name
 */
#ifndef ViewerExport_h
#define ViewerExport_h

#include <string>
#include <vector>

class vtkPolyData;
class ViewerMessages;

/// The supported extensions, with their dots.
std::vector<std::string> GetExportExtensions();

/// Throws ViewerError if the file cannot be written.
void WriteMesh(vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages);

#endif
