// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   texts and numbers in messages and over a picture
 */
#ifndef ViewerText_h
#define ViewerText_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkTextActor;

/// Dark letters on a light background, readable over every picture. Hidden at first.
vtkSmartPointer<vtkTextActor> MakeText();

/// Formats a number with as many digits as differences of this size need.
std::string FormatNumber(double number, double resolution);

/// "1,2.5"
std::string JoinNumbers(const std::vector<double>& numbers);

/// "a, b or c"
std::string JoinWords(const std::vector<std::string>& words);

#endif
