// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes the program of a scene as a Python script
 */
#ifndef PythonCode_h
#define PythonCode_h

#include "Code/ProgramText.h"

#include <string>

class SceneCode;

std::string WritePython(const SceneCode& code, const ProgramText& text);

#endif
