// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   words and numbers, in messages and over a picture
 */
#ifndef ViewerText_h
#define ViewerText_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkTextActor;

/// Dark letters on a light ground, to be read over anything; hidden.
vtkSmartPointer<vtkTextActor> MakeText();

/// With as many digits as differences of that size are worth.
std::string FormatNumber(double number, double resolution);

/// "a, b or c"
std::string JoinWords(const std::vector<std::string>& words);

#endif
