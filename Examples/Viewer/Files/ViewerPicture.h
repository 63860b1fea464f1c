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

/// A name that no file in the current folder has: STEM-1.png, STEM-2.png ... for an input STEM.xyz.
std::string FindPictureName(const std::string& input);

#endif
