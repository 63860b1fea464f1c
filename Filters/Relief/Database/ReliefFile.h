// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a relief's .vti file, and its picture
 *
 * Private to the module's own sources.
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
/// Whether it was written; else the file has the fault.
bool WriteReliefFile(const Relief& relief, AtomicFile& file);
bool WriteReliefPicture(const Relief& relief, AtomicFile& file);
//@}

/// The relief of a .vti file; nullptr, and why in `fault`, if there is none.
vtkSmartPointer<vtkImageData> ReadReliefFile(const std::string& fileName, std::string& error);
}

#endif
