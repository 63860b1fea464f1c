// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes the program of a scene as C++ with its CMakeLists.txt
 */
#ifndef CxxCode_h
#define CxxCode_h

#include "Code/ProgramText.h"

#include <string>

class SceneCode;

std::string WriteCxx(const SceneCode& code, const ProgramText& text);
std::string WriteCMake(const SceneCode& code, const ProgramText& text);

#endif
