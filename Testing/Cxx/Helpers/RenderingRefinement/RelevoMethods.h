// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The methods of vtkAdaptiveRefinementMapper that tests iterate over. Hardware tessellation has
// other triangles and separate tests.
#ifndef RelevoMethods_h
#define RelevoMethods_h

#include "RelevoScene.h"

#include <vector>

namespace RelevoMethods
{
using Mapper = vtkAdaptiveRefinementMapper;

std::vector<int> GetMethods();

const char* GetName(int method);

// Whether the context supports METHOD_HARDWARE_TESSELLATION.
bool HasTessellation();
}

#endif
