// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   saves the picture of a window
 */
#ifndef ViewerPicture_h
#define ViewerPicture_h

#include "Files/AtomicFile.h"

#include <string>

class vtkRenderWindow;
class ViewerMessages;

/// Writes a PNG file. Throws ViewerError on failure.
void WritePicture(vtkRenderWindow* window, const std::string& fileName, ViewerMessages& messages,
  relevo::AtomicFile::OldFile oldFile = relevo::AtomicFile::OldFile::Replace);

#endif
