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
class Relief;

//@{
/// Whether the file was written.
bool WriteReliefFile(const Relief& relief, const std::string& fileName);
bool WriteReliefPicture(const Relief& relief, const std::string& fileName);
//@}

/// The relief of a .vti file; nullptr, and why in `fault`, if there is none.
vtkSmartPointer<vtkImageData> ReadReliefFile(const std::string& fileName, std::string& fault);
}

#endif
