// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The methods of vtkAdaptiveRefinementMapper that tests go through. Hardware tessellation has other
// triangles, and a test of its own.
#ifndef RelevoMethods_h
#define RelevoMethods_h

#include "RelevoScene.h"

#include <vector>

namespace RelevoMethods
{
using Mapper = vtkAdaptiveRefinementMapper;

inline std::vector<int> GetMethods()
{
  return { Mapper::METHOD_ARKFPI, Mapper::METHOD_ARK, Mapper::METHOD_DMR, Mapper::METHOD_SUAPT,
    Mapper::METHOD_UNIFORM };
}

inline const char* GetName(int method)
{
  static const char* const names[] = { "ARKFPI", "ARK", "DMR", "SUAPT", "HardwareTessellation",
    "Uniform" };
  return names[method];
}
}

#endif
