// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reading and writing of the .vti file of a relief, and writing of its image
 *
 * Private to the module.
 */
#ifndef ReliefFile_h
#define ReliefFile_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace relevo
{
class AtomicFile;
class Relief;

//@{
/// Write a file. Return false if that fails, with the error in `file`.
bool WriteReliefFile(const Relief& relief, AtomicFile& file);
bool WriteReliefPicture(const Relief& relief, AtomicFile& file);
//@}

/// Reads a relief from a .vti file. Returns nullptr with an `error` if that fails.
vtkSmartPointer<vtkImageData> ReadReliefFile(const std::string& fileName, std::string& error);
}

#endif
